#include "analysis/measures/protocol_floor.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "oc_core/base/error.h"

namespace ocelli {

MazeFloor floorOf(const ProtocolMaze& maze) {
  const bool isStrange = std::any_of(maze.plan.begin(), maze.plan.end(), [](const std::string& line) {
    return line.find_first_not_of("+-| ") != std::string::npos;
  });
  if (isStrange || lineCountFault(maze.plan.size()) || lineLengthFault(maze.plan)) {
    throw InputError("this drawing is not a valid maze", fmt::format("maze \"{}\" of the protocol", maze.name),
                     "the protocol as the study stored it");
  }
  return {readAnyDrawing(maze.plan), {maze.cellSize, maze.wallThickness}};
}

}  // namespace ocelli
