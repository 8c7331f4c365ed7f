#include "oc_core/render/mesh_blocks.h"

#include "oc_core/base/finite.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

bool hasFiniteCorners(const Mesh& mesh, size_t triangle) {
  const glm::uvec3& t = mesh.triangles[triangle];
  return isFinite(mesh.positions[t.x]) && isFinite(mesh.positions[t.y]) && isFinite(mesh.positions[t.z]);
}

MeshBlocks::MeshBlocks(const Mesh& mesh)
    : mesh_(mesh),
      blocks_((mesh.triangles.size() + kTriangles - 1) / kTriangles),
      runs_((blocks_.size() + kRun - 1) / kRun) {
  parallelFor(runs_.size(), 2, [&](size_t begin, size_t end) {
    for (size_t i = begin * kRun; i < std::min(end * kRun, blocks_.size()); ++i) {
      Block& block = blocks_[i];
      for (size_t k = i * kTriangles; k < std::min((i + 1) * kTriangles, mesh.triangles.size()); ++k) {
        if (!hasFiniteCorners(mesh, k)) {
          block.whole = false;
          continue;
        }
        for (int corner = 0; corner < 3; ++corner) {
          const glm::vec3& p = mesh.positions[mesh.triangles[k][corner]];
          block.box.lower = glm::min(block.box.lower, p);
          block.box.upper = glm::max(block.box.upper, p);
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
