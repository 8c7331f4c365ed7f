// A mesh cut into blocks of neighbouring triangles, with a box around each, and boxes around runs of blocks: renderers
// that draw one part of space after the other find the triangles of a part by them.
//
// DEVIATION: the text finds the triangles of a frustum with an octree (section 4.1). Scenes come in a coherent order,
// so blocks of neighbours in that order do, and take a small part of the time to build.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "oc_core/render/half_spaces.h"

namespace ocelli {

class MeshBlocks {
 public:
  static constexpr size_t kTriangles = 32;  ///< of a block
  static constexpr size_t kRun = 32;        ///< blocks of a run

  struct Block {
    Box box;            ///< around the triangles whose corners are finite
    bool whole = true;  ///< all corners of all its triangles are finite
  };

  /// The mesh must outlive it, and not change.
  explicit MeshBlocks(const Mesh& mesh);

  const Mesh& mesh() const { return mesh_; }
  const Block& operator[](size_t block) const { return blocks_[block]; }
  size_t size() const { return blocks_.size(); }

  /// Calls `visit(block, placement)`, in order, for the blocks that are not outside of the half spaces.
  template <class Visit>
  void forEachWithin(std::span<const HalfSpace> spaces, const Visit& visit) const;

 private:
  const Mesh& mesh_;
  std::vector<Block> blocks_;
  std::vector<Box> runs_;
};

/// Whether the corners of a triangle are numbers.
bool hasFiniteCorners(const Mesh& mesh, size_t triangle);

template <class Visit>
void MeshBlocks::forEachWithin(std::span<const HalfSpace> spaces, const Visit& visit) const {
  for (size_t run = 0; run < runs_.size(); ++run) {
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
