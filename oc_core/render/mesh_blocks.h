// A mesh cut into blocks of neighbouring triangles, with a box around each, and boxes around runs of blocks: renderers
// that draw one part of space after the other find the triangles of a part by them.
//
// DEVIATION: the text finds the triangles of a frustum with an octree (section 4.1). Scenes come in a coherent order,
// so blocks of neighbours in that order do, and take a small part of the time to build. For scenes that are drawn more
// than once, blocks of triangles side by side in space (along a Morton curve) are worth a sort: rows of a height field
// become patches, and objects that are strewn about come by neighbourhoods. Not where triangles are smaller than pixels
// and come in a good order already: there the way to their vertices in memory counts for more.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "oc_core/render/half_spaces.h"

namespace ocelli {

class MeshBlocks {
 public:
  static constexpr size_t kTriangles = 32;  ///< of a block
  static constexpr size_t kRun = 32;        ///< blocks of a run

  struct Block {
    Box box;              ///< around the triangles whose corners are finite
    uint32_t finite = 0;  ///< which these are: bit i is triangle i of the block
  };

  /// Runs [first, last) of blocks.
  struct Runs {
    size_t first = 0;
    size_t last = 0;
  };

  /// Blocks of triangles that are neighbours in the order of the mesh, or in space.
  enum class Order { kOfMesh, kInSpace };

  explicit MeshBlocks(const Mesh& mesh, Order order = Order::kOfMesh);

  /// So many vertices of the mesh, which is otherwise the same, stand elsewhere now.
  void update(const Mesh& mesh, size_t firstVertex, size_t count);

  const Block& operator[](size_t block) const { return blocks_[block]; }
  size_t size() const { return blocks_.size(); }
  size_t runCount() const { return runs_.size(); }
  /// Calls `visit(triangle)`, in their order, for the triangles of a block whose corners are finite.
  template <class Visit>
  void forEachTriangle(uint32_t block, const Visit& visit) const;
  /// Calls `visit(block, placement)`, in order, for the blocks that are not outside of the half spaces.
  template <class Visit>
  void forEachWithin(std::span<const HalfSpace> spaces, const Visit& visit) const {
    forEachWithin({0, runCount()}, spaces, visit);
  }
  /// The same for those of some runs.
  template <class Visit>
  void forEachWithin(Runs runs, std::span<const HalfSpace> spaces, const Visit& visit) const;

 private:
  /// The triangle at a place of the order.
  uint32_t triangleAt(size_t place) const { return order_.empty() ? static_cast<uint32_t>(place) : order_[place]; }
  void measureBlock(const Mesh& mesh, size_t block);
  void measureRun(size_t run);

  std::vector<uint32_t> order_;  ///< triangles; empty where it is that of the mesh
  std::vector<Block> blocks_;
  std::vector<Box> runs_;
  std::vector<std::pair<uint32_t, uint32_t>> vertices_;  ///< the first and the last that each block uses
};

template <class Visit>
void MeshBlocks::forEachTriangle(uint32_t block, const Visit& visit) const {
  for (uint32_t left = blocks_[block].finite; left != 0; left &= left - 1) {
    visit(triangleAt(size_t{block} * kTriangles + static_cast<size_t>(std::countr_zero(left))));
  }
}

template <class Visit>
void MeshBlocks::forEachWithin(Runs runs, std::span<const HalfSpace> spaces, const Visit& visit) const {
  for (size_t run = runs.first; run < runs.last; ++run) {
    if (runs_[run].empty() || placementOf(runs_[run], spaces) == Placement::kOutside) {
      continue;
    }
    for (size_t block = run * kRun; block < std::min((run + 1) * kRun, blocks_.size()); ++block) {
      const Box& box = blocks_[block].box;
      const Placement placement = box.empty() ? Placement::kOutside : placementOf(box, spaces);
      if (placement != Placement::kOutside) {
        visit(static_cast<uint32_t>(block), placement);
      }
    }
  }
}

}  // namespace ocelli
