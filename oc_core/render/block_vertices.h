// The vertices of a block of triangles (mesh_blocks.h), each once and side by side, so that renderers project many at a
// time and look at what the block covers before they draw its triangles one by one.
#pragma once

#include <array>

#include "oc_core/render/mesh_blocks.h"

namespace ocelli {

class BlockVertices {
 public:
  /// Corners of a block at most; whole vectors of projectBlock().
  static constexpr size_t kMaxCount = 3 * MeshBlocks::kTriangles;

  struct Triangle {
    uint32_t index = 0;                ///< in the mesh
    std::array<uint8_t, 3> corners{};  ///< of the vertices here
  };

  /// Takes the triangles of a block that are finite, in their order.
  void collect(const Mesh& mesh, const MeshBlocks& blocks, uint32_t block);

  std::span<const Triangle> triangles() const { return {triangles_.data(), triangleCount_}; }
  /// A few may be here twice.
  size_t size() const { return count_; }
  glm::vec3 position(size_t i) const { return {x_[i], y_[i], z_[i]}; }
  /// Coordinates, kMaxCount of each: what lies behind size() is of no use, but finite.
  const float* x() const { return x_.data(); }
  const float* y() const { return y_.data(); }
  const float* z() const { return z_.data(); }

 private:
  struct Slot {
    uint64_t tag = 0;
    uint8_t place = 0;
  };
  static constexpr size_t kSlots = 128;

  uint64_t serial_ = 0;  ///< of the block: slots of others are empty
  std::array<Slot, kSlots> slots_;
  size_t count_ = 0;
  size_t triangleCount_ = 0;
  std::array<Triangle, MeshBlocks::kTriangles> triangles_;
  alignas(64) std::array<float, kMaxCount> x_{};
  alignas(64) std::array<float, kMaxCount> y_{};
  alignas(64) std::array<float, kMaxCount> z_{};
};

}  // namespace ocelli
