// The shade of every vertex from the normals of its faces (shading.h), for meshes whose vertices move: which faces are
// smooth together is decided once, and each new shape is shaded along the same creases.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

class VertexShading {
 public:
  /// Splits the vertices of `mesh` at the creases that it has as it stands (kCreaseDegrees): a vertex becomes one for
  /// each smooth side, the copies stand at the end, and triangles keep their order.
  explicit VertexShading(Mesh& mesh);

  /// Of each vertex after the split: which one of the mesh before it was.
  const std::vector<uint32_t>& sources() const { return sources_; }

  /// Sets the colours of the mesh that was split, whose vertices may have moved since: `unshaded`, one a vertex, or
  /// white where there is none, times the shade of the area-weighted mean of the normals of its faces. `unlit`, where
  /// it is not empty, says 1 of vertices whose colours stay as they are.
  void shade(Mesh& mesh, std::span<const glm::vec3> unshaded, std::span<const uint8_t> unlit = {});

 private:
  std::vector<uint32_t> sources_;
  std::vector<uint32_t> first_;  ///< vertices + 1 offsets into `faces_`
  std::vector<uint32_t> faces_;  ///< triangles at each vertex, in ascending order
  std::vector<glm::vec3> normals_;
};

}  // namespace ocelli
