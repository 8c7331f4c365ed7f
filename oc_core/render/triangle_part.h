// Some of the triangles of a mesh, ready to be drawn by cameras that share a reference pinhole: in blocks of
// neighbours, with a box around the image of each.
#pragma once

#include <array>
#include <bit>
#include <limits>
#include <memory>
#include <vector>

#include "oc_core/base/parallel.h"
#include "oc_core/camera/distorted_pinhole.h"
#include "oc_core/render/projected_mesh.h"

namespace ocelli {

struct TrianglePart {
  static constexpr size_t kTriangles = 32;  ///< of a block

  struct Block {
    uint32_t first = 0;     ///< triangle of the mesh
    uint32_t selected = 0;  ///< bit i: triangle first + i is of the part
    uint32_t small = 0;     ///< and no edge of its image, as the reference pinhole sees it, is longer than a pixel

    /// Calls `visit(triangle, isSmall)` for those of the part, in order.
    template <class Visit>
    void forEach(const Visit& visit) const {
      for (uint32_t left = selected; left != 0; left &= left - 1) {
        visit(first + static_cast<uint32_t>(std::countr_zero(left)), (left & small & -left) != 0);
      }
    }
  };

  std::shared_ptr<const ProjectedMesh> mesh;  ///< as the reference pinhole sees it; none where there are no blocks
  std::vector<Block> blocks;

  size_t size() const {
    size_t count = 0;
    for (const Block& block : blocks) {
      count += static_cast<size_t>(std::popcount(block.selected));
    }
    return count;
  }
};

inline ImageBox boxAround(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  return {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
}

/// Whether no edge of a triangle's image is longer than a pixel.
inline bool isSmall(const ProjectedVertex& a, const ProjectedVertex& b, const ProjectedVertex& c) {
  const auto squared = [](const ProjectedVertex& p, const ProjectedVertex& q) {
    return (p.u - q.u) * (p.u - q.u) + (p.v - q.v) * (p.v - q.v);
  };
  return squared(a, b) <= 1 && squared(b, c) <= 1 && squared(c, a) <= 1;
}

/// The wanted ones of triangles [begin, end).
template <class Predicate>
TrianglePart::Block selectFromBlock(const ProjectedMesh& mesh, size_t begin, size_t end, const Predicate& isWanted) {
  constexpr float kFarOut = std::numeric_limits<float>::infinity();
  std::array<ImageBox, TrianglePart::kTriangles> boxes;
  ImageBox whole{glm::vec2(kFarOut), glm::vec2(-kFarOut)};
  TrianglePart::Block block{static_cast<uint32_t>(begin), 0, 0};
  for (size_t i = begin; i < end; ++i) {
    const glm::uvec3& t = mesh.mesh().triangles[i];
    const ProjectedVertex& a = mesh.vertex(t.x);
    const ProjectedVertex& b = mesh.vertex(t.y);
    const ProjectedVertex& c = mesh.vertex(t.z);
    ImageBox& box = boxes[i - begin];
    if (a.inverseZ > 0 && b.inverseZ > 0 && c.inverseZ > 0) {
      block.small |= isSmall(a, b, c) ? 1u << (i - begin) : 0u;
      box = boxAround({a.u, a.v}, {b.u, b.v}, {c.u, c.v});
      whole = {glm::min(whole.lower, box.lower), glm::max(whole.upper, box.upper)};
    } else {
      block.selected |= 1u << (i - begin);
    }
  }
  if (whole.lower.x <= whole.upper.x && isWanted(whole)) {
    for (size_t i = begin; i < end; ++i) {
      const uint32_t bit = 1u << (i - begin);
      if ((block.selected & bit) == 0 && isWanted(boxes[i - begin])) {
        block.selected |= bit;
      }
    }
  }
  return block;
}

/// The triangles whose image, as the pinhole of `mesh` sees it, lies in a box that `isWanted` holds for; it is called
/// from several threads, and must hold for a box that holds one that is wanted. Those with a vertex that has no image
/// are always among them.
template <class Predicate>
TrianglePart selectTriangles(std::shared_ptr<const ProjectedMesh> mesh, const Predicate& isWanted) {
  const std::vector<glm::uvec3>& triangles = mesh->mesh().triangles;
  const size_t count = (triangles.size() + TrianglePart::kTriangles - 1) / TrianglePart::kTriangles;
  constexpr size_t kPartChunks = 64;
  std::vector<std::vector<TrianglePart::Block>> found(kPartChunks);
  parallelChunks(count, kPartChunks, [&](size_t chunk, size_t begin, size_t end) {
    for (size_t index = begin; index < end; ++index) {
      const size_t first = index * TrianglePart::kTriangles;
      const TrianglePart::Block block =
          selectFromBlock(*mesh, first, std::min(first + TrianglePart::kTriangles, triangles.size()), isWanted);
      if (block.selected != 0) {
        found[chunk].push_back(block);
      }
    }
  });
  TrianglePart part{std::move(mesh), {}};
  for (const std::vector<TrianglePart::Block>& blocks : found) {
    part.blocks.insert(part.blocks.end(), blocks.begin(), blocks.end());
  }
  return part;
}

}  // namespace ocelli
