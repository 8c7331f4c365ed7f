// A scene as relief tiles take it (section 3.5.2.3.2): objects that are made into an image once, where copies of them
// stand, and all else. Nothing has light baked in: copies are turned.
#pragma once

#include <string>
#include <vector>

#include "oc_core/worlds/object_roles.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

struct TiledScene {
  /// Each in the unit sphere, y up: tile coordinates.
  std::vector<Mesh> objects;
  struct Tile {
    size_t object = 0;
    glm::mat4 worldFromTile{1};
    glm::vec3 tint{1};  ///< linear; multiplies the colours of the object
  };
  std::vector<Tile> tiles;
  Mesh around;  ///< what has not the role `relief`, in the world

  /// The tiles as one mesh.
  Mesh flatTiles() const;
};

/// Copies of the same mesh of a scene, and of the same source of the roles, are tiles of one object. `worldFromScene`
/// is what fitted the scene. Throws InputError for scenes that keep no meshes apart: packed ones, and those that move.
TiledScene loadTiledScene(const std::string& source, const std::vector<RoledObject>& roles,
                          const glm::mat4& worldFromScene, const SceneOptions& options = {},
                          const Progress& progress = {});

/// Where an object that comes to a scene stands: one of `places`, or its own centre.
std::vector<glm::mat4> placesOf(const RoledObject& object);

}  // namespace ocelli
