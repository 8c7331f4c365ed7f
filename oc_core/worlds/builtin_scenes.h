// Scenes made by code: `builtin:NAME[,key=value...]`.
//
// Recipe for a new one, two files:
//   1. oc_core/worlds/builtin_NAME.cpp: a function that returns its BuiltinScene, declared in
//      oc_core/worlds/builtin_list.h;
//   2. oc_core/worlds/builtin_scenes.cpp: add it to the list.
// Those of one object fit the unit sphere, with their front towards +z, whence the default view looks. Those to walk
// through (mazes, the town, the city, the house, the canyon) are in metres; fitting a scene scales them down, and
// GuidedScene says how.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/scene/builtin_parameters.h"
#include "oc_core/scene/moving_scene.h"
#include "oc_core/scene/scene.h"
#include "oc_core/worlds/object_roles.h"

namespace ocelli {

struct BuiltinScene {
  std::string name;
  std::string summary;  ///< one line
  std::vector<BuiltinParameter> parameters;
  std::function<Scene(const BuiltinValues&)> build;
  /// Of a scene that moves; empty where it stands still. `build` makes what it is at rest.
  std::function<std::unique_ptr<MovingScene>(const BuiltinValues&)> motion = {};
  /// What its objects are to rays that go on from surfaces; none where nothing says so.
  std::vector<RoledObject> roles = {};
};

const std::vector<BuiltinScene>& listBuiltinScenes();

bool isBuiltinScene(std::string_view source);

/// Builds the scene that `source` ("builtin:NAME,key=value,...") names. Throws InputError that lists the valid names,
/// keys or the range for an unknown scene, an unknown, repeated or malformed parameter, or a value out of range.
Scene makeBuiltinScene(const std::string& source);

/// The roles of its objects; none where it has none. Throws as makeBuiltinScene() does for an unknown one.
const std::vector<RoledObject>& builtinRoles(const std::string& source);

/// Whether the one that `source` names moves. Throws as makeBuiltinScene() does for an unknown one.
bool isMovingBuiltin(const std::string& source);
/// Its motion. Throws as makeBuiltinScene() does. Only where isMovingBuiltin() holds.
std::unique_ptr<MovingScene> makeBuiltinMotion(const std::string& source);

}  // namespace ocelli
