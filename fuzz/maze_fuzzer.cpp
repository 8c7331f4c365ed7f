// libFuzzer target: any bytes as a maze file. What is read is drawn, walked and written again.
#include <cstdlib>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/worlds/maze_file.h"
#include "oc_core/worlds/maze_graph.h"
#include "oc_core/worlds/maze_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const ocelli::Maze maze = ocelli::mazeFromJsonText(std::string(data, data + size), "fuzz");
    const ocelli::MazeGraph graph(maze);
    for (const ocelli::Crossing& crossing : graph.crossings) {
      for (const ocelli::Direction direction : maze.passages(crossing.cell)) {
        maze.ahead(crossing.cell, direction);
        maze.openingOf(crossing.cell, direction);
      }
    }
    ocelli::validate(flatten(ocelli::makeMazeScene(maze)), "fuzz");
    if (!(ocelli::mazeFromJsonText(ocelli::jsonText(maze), "fuzz") == maze)) {
      std::abort();
    }
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
  return 0;
}
