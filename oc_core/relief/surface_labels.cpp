#include "oc_core/relief/surface_labels.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/scene/shading.h"
#include "oc_core/scene/vertex_shading.h"

namespace ocelli {

SurfaceLabels::SurfaceLabels(const Mesh& mesh) : mesh_(mesh) {
  const VertexShading split(mesh_);
  normals_.assign(mesh_.positions.size(), glm::vec3(0));
  for (const glm::uvec3& t : mesh_.triangles) {
    const glm::vec3 normal = areaNormal(mesh_.positions[t.x], mesh_.positions[t.y], mesh_.positions[t.z]);
    for (int corner = 0; corner < 3; ++corner) {
      normals_[t[corner]] += normal;
    }
  }
  for (glm::vec3& normal : normals_) {
    const float length = glm::length(normal);
    normal = length > 0 ? normal / length : glm::vec3(0, 1, 0);
  }
}

Mesh SurfaceLabels::labelledMesh() const {
  if (mesh_.triangles.size() > kMaxTriangles) {
    throw InputError("a relief tile has " + std::to_string(mesh_.triangles.size()) + " triangles, more than " +
                         std::to_string(kMaxTriangles),
                     "the object with the role \"relief\"", "simplify it");
  }
  Mesh labelled;
  labelled.isPart = mesh_.isPart;
  const size_t corners = 3 * mesh_.triangles.size();
  labelled.positions.reserve(corners);
  labelled.colors.reserve(corners);
  labelled.triangles.reserve(mesh_.triangles.size());
  for (size_t i = 0; i < mesh_.triangles.size(); ++i) {
    const auto base = static_cast<uint32_t>(labelled.positions.size());
    for (int corner = 0; corner < 3; ++corner) {
      labelled.positions.push_back(mesh_.positions[mesh_.triangles[i][corner]]);
      labelled.colors.push_back({static_cast<float>(i), corner == 1 ? 1.0f : 0.0f, corner == 2 ? 1.0f : 0.0f});
    }
    labelled.triangles.push_back({base, base + 1, base + 2});
  }
  return labelled;
}

ReliefSurface SurfaceLabels::surfaceOf(const glm::vec3& label) const {
  const long number = std::lround(label.x);
  const long last = static_cast<long>(mesh_.triangles.size()) - 1;
  return surfaceOf(static_cast<size_t>(std::clamp(number, 0L, last)), label.y, label.z);
}

ReliefSurface SurfaceLabels::surfaceOf(size_t triangle, float b1, float b2) const {
  const glm::uvec3& t = mesh_.triangles[triangle];
  const float b0 = 1 - b1 - b2;
  return {mesh_.color(t.x) * b0 + mesh_.color(t.y) * b1 + mesh_.color(t.z) * b2,
          normals_[t.x] * b0 + normals_[t.y] * b1 + normals_[t.z] * b2};
}

}  // namespace ocelli
