#include "oc_core/worlds/builtin_scenes.h"

#include <span>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/volume/builtin_volumes.h"
#include "oc_core/worlds/builtin_list.h"

namespace ocelli {
namespace {

constexpr std::string_view kPrefix = "builtin:";

const BuiltinScene& findScene(const std::string& name, const std::string& source) {
  for (const BuiltinScene& scene : listBuiltinScenes()) {
    if (scene.name == name) {
      return scene;
    }
  }
  throw InputError("there is no built-in scene '" + name + "'", source, "one of " + listNames(listBuiltinScenes()));
}

struct ParsedBuiltin {
  const BuiltinScene* scene;
  BuiltinValues values;
};

ParsedBuiltin parsed(const std::string& source) {
  OC_CHECK(isBuiltinScene(source), "callers ask isBuiltinScene() first");
  const std::vector<std::string> pieces = splitAtCommas(source.substr(kPrefix.size()));
  const BuiltinScene& builtin = findScene(pieces[0], source);
  return {&builtin, readBuiltinValues(builtin.parameters, std::span(pieces).subspan(1),
                                      {"the scene " + builtin.name, "builtin:" + builtin.name}, source)};
}

}  // namespace

const std::vector<BuiltinScene>& listBuiltinScenes() {
  static const std::vector<BuiltinScene> scenes{
      teapotScene(),    roomScene(),   statuesScene(),  crowdScene(),      fenceScene(),   doorsScene(),
      boxesScene(),     mazeScene(),   townScene(),     canyonScene(),     sphereScene(),  torusScene(),
      boxScene(),       wavingScene(), mirrorScene(),   mirrorMazeScene(), lensScene(),    parkingScene(),
      cityScene(),      houseScene(),  barrelsScene(),  lampScene(),       pergolaScene(), dnaScene(),
      particlesScene(), treeScene(),   museumScene(),   officeScene(),     libraryScene(), corridorTScene(),
      corridorScene(),  shopScene(),   courtyardScene()};
  return scenes;
}

bool isBuiltinScene(std::string_view source) {
  return source.substr(0, kPrefix.size()) == kPrefix && !isBuiltinVolume(std::string(source));
}

Scene makeBuiltinScene(const std::string& source) {
  const auto [builtin, values] = parsed(source);
  Scene scene = builtin->build(values);
  scene.name = source;
  return scene;
}

const std::vector<RoledObject>& builtinRoles(const std::string& source) {
  const std::vector<std::string> pieces = splitAtCommas(source.substr(kPrefix.size()));
  return findScene(pieces[0], source).roles;
}

bool isMovingBuiltin(const std::string& source) {
  const std::vector<std::string> pieces = splitAtCommas(source.substr(kPrefix.size()));
  return static_cast<bool>(findScene(pieces[0], source).motion);
}

std::unique_ptr<MovingScene> makeBuiltinMotion(const std::string& source) {
  const auto [builtin, values] = parsed(source);
  OC_CHECK(builtin->motion != nullptr, "callers ask isMovingBuiltin() first");
  return builtin->motion(values);
}

}  // namespace ocelli
