#include "oc_core/render/mesh_blocks.h"

#include <array>
#include <glm/common.hpp>

#include "oc_core/base/finite.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

MeshBlocks::MeshBlocks(const Mesh& mesh)
    : blocks_((mesh.triangles.size() + kTriangles - 1) / kTriangles), runs_((blocks_.size() + kRun - 1) / kRun) {
  parallelFor(runs_.size(), 2, [&](size_t begin, size_t end) {
    for (size_t i = begin * kRun; i < std::min(end * kRun, blocks_.size()); ++i) {
      Block& block = blocks_[i];
      for (size_t k = i * kTriangles; k < std::min((i + 1) * kTriangles, mesh.triangles.size()); ++k) {
        const glm::uvec3& t = mesh.triangles[k];
        const std::array<glm::vec3, 3> corners{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
        if (!std::all_of(corners.begin(), corners.end(), [](const glm::vec3& p) { return isFinite(p); })) {
          continue;
        }
        block.finite |= 1u << (k - i * kTriangles);
        for (const glm::vec3& corner : corners) {
          block.box.lower = glm::min(block.box.lower, corner);
          block.box.upper = glm::max(block.box.upper, corner);
        }
      }
      if (!block.box.empty()) {
        runs_[i / kRun].add(block.box.lower);
        runs_[i / kRun].add(block.box.upper);
      }
    }
  });
}

}  // namespace ocelli
