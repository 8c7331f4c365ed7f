#include "oc_core/render/mesh_blocks.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/gtc/type_precision.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "oc_core/base/finite.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// The bits of a number of 21 bits, two zeros between each and the next.
uint64_t spreadBits(uint64_t bits) {
  bits &= 0x1fffff;
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

/// Triangles along a Morton curve through the middles of their boxes; those that are not finite come last.
std::vector<uint32_t> orderInSpace(const Mesh& mesh) {
  Box bounds;
  for (const glm::vec3& p : mesh.positions) {
    if (isFinite(p)) {
      bounds.add(p);
    }
  }
  constexpr double kCells = (1 << 21) - 1;
  const glm::dvec3 lower(bounds.lower);
  const double size = [&] {
    const glm::dvec3 extent = glm::dvec3(bounds.upper) - lower;
    return std::max({extent.x, extent.y, extent.z});
  }();
  std::vector<std::pair<uint64_t, uint32_t>> keys(mesh.triangles.size());
  parallelFor(keys.size(), 1 << 12, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::uvec3& t = mesh.triangles[i];
      const std::array<glm::dvec3, 3> corners{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
      const glm::dvec3 middle = (glm::min(corners[0], glm::min(corners[1], corners[2])) +
                                 glm::max(corners[0], glm::max(corners[1], corners[2]))) *
                                0.5;
      const glm::dvec3 cell = (middle - lower) * (size > 0 ? kCells / size : 0);
      const bool isPlaced = glm::all(glm::greaterThanEqual(cell, glm::dvec3(0))) &&
                            glm::all(glm::lessThanEqual(cell, glm::dvec3(kCells)));
      const glm::u64vec3 at(isPlaced ? cell : glm::dvec3(0));
      keys[i] = {isPlaced ? spreadBits(at.x) | spreadBits(at.y) << 1 | spreadBits(at.z) << 2 : ~uint64_t{0},
                 static_cast<uint32_t>(i)};
    }
  });
  std::sort(keys.begin(), keys.end());
  std::vector<uint32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const auto& key) { return key.second; });
  return order;
}

}  // namespace

MeshBlocks::MeshBlocks(const Mesh& mesh, Order order)
    : order_(order == Order::kInSpace ? orderInSpace(mesh) : std::vector<uint32_t>()),
      blocks_((mesh.triangles.size() + kTriangles - 1) / kTriangles),
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
    const glm::uvec3& t = mesh.triangles[triangleAt(k)];
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
