// What a scene tells the constructors of cameras about itself: where its openings are, a path through it, what to keep
// in sight. Built-in scenes know; files do not.
#pragma once

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

struct SceneGuides {
  std::vector<Portal> portals;
  std::vector<glm::vec3> path;
  std::optional<SceneTarget> target;
  std::optional<Maze> maze;
  std::optional<WalkMap> walk;  ///< where one can walk: of scenes that know it, or once it was found
};

/// The same guides where the transform of their scene puts them: a uniform scale and a translation.
SceneGuides moved(const SceneGuides& guides, const glm::mat4& newFromOld);

}  // namespace ocelli
