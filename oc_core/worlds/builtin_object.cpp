#include "oc_core/worlds/builtin_object.h"

#include <cstdlib>
#include <filesystem>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/scene/scene_file.h"
#include "oc_core/worlds/packed_source.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/teapot.h"

namespace ocelli {

namespace fs = std::filesystem;

fs::path findFile(const std::string& given, const std::string& what) {
  std::error_code error;
  if (fs::exists(given, error)) {
    return given;
  }
  const char* folder = std::getenv("OCELLI_DATA_DIR");
  if (folder == nullptr || *folder == '\0') {
    throw InputError("there is no such " + what + " file", given,
                     "give its path, or set OCELLI_DATA_DIR to the folder that holds it");
  }
  const fs::path below = fs::path(folder) / given;
  if (!fs::exists(below, error)) {
    throw InputError("there is no such " + what + " file, neither here nor at " + below.string(), given,
                     "give its path, or set OCELLI_DATA_DIR to the folder that holds it");
  }
  return below;
}

BuiltinParameter meshParameter() {
  return {"mesh", "scene file to show; the teapot where none is given", BuiltinParameter::Kind::kFile, "", 0, 0};
}

BuiltinParameter turnParameter() {
  return {"turn", "of the object about the vertical, in degrees", BuiltinParameter::Kind::kNumber, "0", -360, 360};
}

BuiltinParameter trianglesParameter() {
  return {"triangles",
          "densify to about so many triangles in the whole scene; 0 leaves it as it is",
          BuiltinParameter::Kind::kInteger,
          "0",
          0,
          static_cast<double>(kMaxSceneTriangles)};
}

Mesh readObject(const BuiltinValues& values, std::vector<std::string>& warnings) {
  Mesh object;
  const std::string& given = values.path("mesh");
  if (given.empty()) {
    object = makeTeapot(24);
  } else {
    const fs::path path = findFile(given, "mesh");
    if (isPackedScene(path.string())) {
      throw InputError("a packed scene is fitted and shaded already, and no object of a built-in one", path.string(),
                       "give the file that it was packed from");
    }
    const Scene scene = readSceneFile(path);
    object = flatten(scene);
    warnings.insert(warnings.end(), scene.warnings.begin(), scene.warnings.end());
    validate(object, path.string());
  }
  const auto turn = static_cast<float>(radiansFromDegrees(values.number("turn")));
  transform(object, glm::rotate(glm::mat4(1), turn, glm::vec3(0, 1, 0)));
  const Box box = boundsOf(object);
  glm::mat4 standing(1);
  standing[3] = glm::vec4(-box.center().x, -box.lower.y, -box.center().z, 1);
  transform(object, standing);
  return object;
}

Mesh makeRoom() {
  Mesh room;
  addCheckerFloor(room, {-kRoomHalf.x, -kRoomHalf.z}, {kRoomHalf.x, kRoomHalf.z}, -kRoomHalf.y, 14, 9, palette::slate(),
                  palette::ivory());
  addBrickWall(room, {-kRoomHalf.x, -kRoomHalf.y}, {kRoomHalf.x, kRoomHalf.y}, -kRoomHalf.z, 11, 7);
  return room;
}

void tiltRoom(Scene& scene) {
  constexpr double kTiltDegrees = 14;
  const glm::mat4 tilt =
      glm::rotate(glm::mat4(1), static_cast<float>(radiansFromDegrees(kTiltDegrees)), glm::vec3(1, 0, 0));
  for (Instance& instance : scene.instances) {
    instance.worldFromMesh = tilt * instance.worldFromMesh;
  }
}

}  // namespace ocelli
