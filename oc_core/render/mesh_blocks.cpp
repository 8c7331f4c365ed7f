#include "oc_core/render/mesh_blocks.h"

#include <array>
#include <glm/common.hpp>
#include <limits>

#include "oc_core/base/finite.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

MeshBlocks::MeshBlocks(const Mesh& mesh)
    : blocks_((mesh.triangles.size() + kTriangles - 1) / kTriangles),
      runs_((blocks_.size() + kRun - 1) / kRun),
      vertices_(blocks_.size()) {
  parallelFor(runs_.size(), 2, [&](size_t begin, size_t end) {
    for (size_t run = begin; run < end; ++run) {
      for (size_t i = run * kRun; i < std::min((run + 1) * kRun, blocks_.size()); ++i) {
        measureBlock(mesh, i);
      }
      measureRun(run);
    }
  });
}

void MeshBlocks::update(const Mesh& mesh, size_t firstVertex, size_t count) {
  for (size_t run = 0; run < runs_.size(); ++run) {
    bool changed = false;
    for (size_t i = run * kRun; i < std::min((run + 1) * kRun, blocks_.size()); ++i) {
      if (vertices_[i].first < firstVertex + count && vertices_[i].second >= firstVertex) {
        measureBlock(mesh, i);
        changed = true;
      }
    }
    if (changed) {
      measureRun(run);
    }
  }
}

void MeshBlocks::measureBlock(const Mesh& mesh, size_t i) {
  Block block;
  std::pair<uint32_t, uint32_t> vertices(std::numeric_limits<uint32_t>::max(), 0);
  for (size_t k = i * kTriangles; k < std::min((i + 1) * kTriangles, mesh.triangles.size()); ++k) {
    const glm::uvec3& t = mesh.triangles[k];
    vertices = {std::min({vertices.first, t.x, t.y, t.z}), std::max({vertices.second, t.x, t.y, t.z})};
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
  blocks_[i] = block;
  vertices_[i] = vertices;
}

void MeshBlocks::measureRun(size_t run) {
  runs_[run] = Box();
  for (size_t i = run * kRun; i < std::min((run + 1) * kRun, blocks_.size()); ++i) {
    if (!blocks_[i].box.empty()) {
      runs_[run].add(blocks_[i].box.lower);
      runs_[run].add(blocks_[i].box.upper);
    }
  }
}

}  // namespace ocelli
