// What the samples of an image show of a mesh: which triangle, and where on it.
//
// Builders of reference images keep a colour at each sample, and nothing else of the surface. So a copy of the mesh is
// given to them whose colours are labels: the number of the triangle and two barycentric weights. Each triangle has
// vertices of its own there, so that numbers are not interpolated. From the labels of the samples come colours,
// normals, and whatever else the mesh knows.
#pragma once

#include <vector>

#include "oc_core/relief/relief_object.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class SurfaceLabels {
 public:
  /// The most triangles that labels tell apart after single precision has interpolated them.
  static constexpr size_t kMaxTriangles = 1 << 20;

  /// Keeps a copy of the mesh.
  explicit SurfaceLabels(const Mesh& mesh);

  /// The copy with labels for colours; triangles are in the order of the mesh. Throws InputError where it has more
  /// triangles than kMaxTriangles.
  Mesh labelledMesh() const;
  /// What the surface is where a sample has this label.
  ReliefSurface surfaceOf(const glm::vec3& label) const;
  /// The same by barycentric weights of the second and third vertex.
  ReliefSurface surfaceOf(size_t triangle, float b1, float b2) const;
  /// The mesh, whose vertices are split at creases.
  const Mesh& mesh() const { return mesh_; }

 private:
  Mesh mesh_;
  std::vector<glm::vec3> normals_;
};

}  // namespace ocelli
