// `builtin:maze`: a maze from a seed or a file, to walk through or to see in one image.
#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/builtin_object.h"
#include "oc_core/worlds/maze_file.h"
#include "oc_core/worlds/maze_generator.h"
#include "oc_core/worlds/maze_mesh.h"

namespace ocelli {
namespace {

using Kind = BuiltinParameter::Kind;

std::vector<BuiltinParameter> parameters() {
  return {{"seed", "of the random numbers", Kind::kInteger, "1", 0, 4294967295.0},
          {"rows", "of cells", Kind::kInteger, "7", 1, kMaxMazeSide},
          {"columns", "of cells", Kind::kInteger, "7", 1, kMaxMazeSide},
          {"loops", "share of the inner walls that is opened again", Kind::kNumber, "0.15", 0, 1},
          {"three", "crossings of 3 ways that there are at least", Kind::kInteger, "0", 0, 4096},
          {"four", "crossings of 4 ways that there are at least", Kind::kInteger, "0", 0, 4096},
          {"landmarks", "objects in the corridors, in different cells", Kind::kInteger, "10", 0, 4096},
          {"file", "maze file (JSON) instead of all this", Kind::kFile, "", 0, 0}};
}

Scene buildMaze(const BuiltinValues& values) {
  if (values.isGiven("file")) {
    for (const BuiltinParameter& parameter : parameters()) {
      if (parameter.name != "file" && values.isGiven(parameter.name)) {
        throw InputError("'file' and '" + parameter.name + "' are given, but a maze from a file is as the file says",
                         "builtin:maze", "leave one of them out");
      }
    }
    return makeMazeScene(readMaze(findFile(values.path("file"), "maze")));
  }
  MazeOptions options;
  options.seed = values.count("seed");
  options.rows = static_cast<int>(values.count("rows"));
  options.columns = static_cast<int>(values.count("columns"));
  options.loops = values.number("loops");
  options.minThreeWay = values.count("three");
  options.minFourWay = values.count("four");
  options.landmarks = values.count("landmarks");
  if (!values.isGiven("landmarks")) {
    options.landmarks = std::min(options.landmarks, values.count("rows") * values.count("columns"));
  }
  return makeMazeScene(generateMaze(options));
}

}  // namespace

BuiltinScene mazeScene() {
  return {"maze", "a maze with landmarks, from a seed or a file; in metres", parameters(), buildMaze};
}

}  // namespace ocelli
