#include "oc_core/render/projected_mesh.h"

#include <array>
#include <cmath>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// Projects vertices [begin, end), as PinholeCamera::project does, in runs whose loops the compiler can vectorise.
void projectVertices(const PinholeCamera& camera, const Mesh& mesh, size_t begin, size_t end,
                     std::vector<ProjectedVertex>& vertices, std::vector<CentreCell>& cells) {
  constexpr size_t kRun = 128;
  std::array<float, kRun> x{};
  std::array<float, kRun> y{};
  std::array<float, kRun> z{};
  std::array<float, kRun> inverseZ{};
  std::array<CentreCell, kRun> inside;
  const glm::vec3 eye = camera.eye();
  const glm::vec3 right = camera.right();
  const glm::vec3 down = camera.down();
  const glm::vec3 forward = camera.forward();
  const glm::vec2 center = camera.centerPixels();
  const float focal = camera.focalPixels();
  const float zNear = camera.view().zNear;
  const float zFar = camera.view().zFar;
  for (size_t first = begin; first < end; first += kRun) {
    const size_t count = std::min(kRun, end - first);
    for (size_t i = 0; i < count; ++i) {
      const glm::vec3& p = mesh.positions[first + i];
      x[i] = p.x - eye.x;
      y[i] = p.y - eye.y;
      z[i] = p.z - eye.z;
    }
    for (size_t i = 0; i < kRun; ++i) {
      const float px = x[i] * right.x + y[i] * right.y + z[i] * right.z;
      const float py = x[i] * down.x + y[i] * down.y + z[i] * down.z;
      const float pz = x[i] * forward.x + y[i] * forward.y + z[i] * forward.z;
      x[i] = center.x + focal * px / pz;
      y[i] = center.y + focal * py / pz;
      z[i] = pz;
      inverseZ[i] = 1 / pz;
    }
    for (size_t i = 0; i < kRun; ++i) {
      inside[i] = CentreCell(x[i], y[i]);
    }
    for (size_t i = 0; i < count; ++i) {
      const float farthest = std::max(std::abs(x[i]), std::abs(y[i]));
      const bool seen = z[i] >= zNear && z[i] <= zFar && std::isfinite(x[i]) && std::isfinite(y[i]);
      vertices[first + i] = {x[i], y[i], seen ? inverseZ[i] : 0};
      cells[first + i] = seen && farthest < CentreCell::kMaxPixels ? inside[i] : CentreCell::unknown();
    }
  }
}

}  // namespace

ProjectedMesh::ProjectedMesh(const PinholeCamera& camera, const Mesh& mesh)
    : camera_(camera), mesh_(&mesh), vertices_(mesh.positions.size()), cells_(mesh.positions.size()) {
  parallelFor(vertices_.size(), 1 << 12,
              [&](size_t begin, size_t end) { projectVertices(camera, mesh, begin, end, vertices_, cells_); });
}

}  // namespace ocelli
