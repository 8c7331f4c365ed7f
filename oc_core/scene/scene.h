// A scene: meshes and where copies of them stand. Renderers take the flat mesh that flatten() makes of it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// A copy of a mesh, moved into the world.
struct Instance {
  size_t mesh = 0;
  glm::mat4 worldFromMesh{1};
};

struct Scene {
  std::string name;  ///< as the user wrote it
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;

  void add(Mesh mesh, const glm::mat4& worldFromMesh = glm::mat4(1));
};

Mesh flatten(const Scene& scene);

/// The uniform scale and translation that put the bounding sphere of `mesh` onto the unit sphere around the origin.
/// The sphere is the one around the centre of the bounding box that holds every vertex.
glm::mat4 unitFromWorld(const Mesh& mesh);
void transform(Mesh& mesh, const glm::mat4& newFromOld);

}  // namespace ocelli
