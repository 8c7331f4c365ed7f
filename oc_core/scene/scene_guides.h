// What a scene tells the constructors of cameras about itself: where its openings are, a path through it, what to keep
// in sight. Built-in scenes know; files do not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "oc_core/scene/maze.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/scene/portal.h"
#include "oc_core/scene/walk_map.h"

namespace ocelli {

/// An object to keep in sight.
struct SceneTarget {
  uint32_t object = 0;  ///< its identity (Instance::object)
  Box box;
};

/// How many images a sea of images of a place takes, and how far apart along the path of its guides (section 3.5.4).
struct SeaWalk {
  size_t count = 0;
  float spacing = 0;  ///< in units of the scene
};

struct SceneGuides {
  std::vector<Portal> portals;
  std::vector<glm::vec3> path;
  std::optional<SceneTarget> target;
  std::optional<Maze> maze;
  std::optional<SeaWalk> sea;   ///< of places whose path is made for one: it is (count - 1) spacings long
  std::optional<WalkMap> walk;  ///< where one can walk: of scenes that know it, or once it was found
};

/// The same guides where the transform of their scene puts them: a uniform scale and a translation.
SceneGuides moved(const SceneGuides& guides, const glm::mat4& newFromOld);

/// The places of the images of a sea: `sea.count` points along `path`, from its beginning on, each `sea.spacing`
/// further along it. Throws InputError where the path is shorter than that by more than a spacing.
std::vector<glm::vec3> seaPositions(const std::vector<glm::vec3>& path, const SeaWalk& sea);

}  // namespace ocelli
