// Lit voxels of one thread, gathered by slice, so that a slice is in the cache when they are added to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "oc_core/image/png_file.h"

namespace ocelli {

/// A lit voxel of a known slice: where it is (its row times the columns of a padded row, plus its column), and the
/// levels of its channels from the least significant bit: one bit each for red, green and blue, or eight.
struct OneBitVoxel {
  using PackedVoxel = uint32_t;
  static constexpr int kLevelBits = 1;
};
struct ManyBitVoxel {
  using PackedVoxel = uint64_t;
  static constexpr int kLevelBits = 8;
};

template <class Voxel>
constexpr typename Voxel::PackedVoxel packVoxel(uint32_t position, uint32_t levels) {
  return static_cast<typename Voxel::PackedVoxel>(position) << 3 * Voxel::kLevelBits | levels;
}

template <class Voxel>
constexpr uint32_t packedLevels(const Rgb8& levels) {
  return levels.r | static_cast<uint32_t>(levels.g) << Voxel::kLevelBits |
         static_cast<uint32_t>(levels.b) << 2 * Voxel::kLevelBits;
}

template <class Voxel>
class PackedVoxelBins {
 public:
  using PackedVoxel = typename Voxel::PackedVoxel;

  explicit PackedVoxelBins(size_t bins) : memory_(bins), bins_(bins) {
    for (size_t i = 0; i < bins; ++i) {
      memory_[i].resize(kFirstRoom);
      bins_[i] = {memory_[i].data(), memory_[i].data() + kFirstRoom};
    }
  }

  /// Appends to bin `indices[i]` the i-th voxel of `count`. Of equal neighbours one is enough. The last bin stays
  /// empty.
  template <class VoxelOf>
  void push(const uint32_t* indices, VoxelOf&& voxelOf, size_t count) {
    PackedVoxel last = 0;
    const auto none = static_cast<uint32_t>(bins_.size() - 1);
    uint32_t lastIndex = none;
    for (size_t i = 0; i < count; ++i) {
      const uint32_t index = indices[i];
      const PackedVoxel voxel = voxelOf(i);
      Bin& bin = bins_[index];
      *bin.next = voxel;
      bin.next += (voxel != last || index != lastIndex) && index != none ? 1 : 0;
      last = voxel;
      lastIndex = index;
      if (bin.next == bin.end) {
        grow(index);
      }
    }
  }

  std::span<const PackedVoxel> of(size_t index) const {
    return {memory_[index].data(), static_cast<size_t>(bins_[index].next - memory_[index].data())};
  }
  void clear(size_t index) { bins_[index].next = memory_[index].data(); }

 private:
  static constexpr size_t kFirstRoom = 1024;
  struct Bin {
    PackedVoxel* next = nullptr;
    PackedVoxel* end = nullptr;
  };

  void grow(size_t index) {
    const size_t size = memory_[index].size();
    memory_[index].resize(2 * size);
    bins_[index] = {memory_[index].data() + size, memory_[index].data() + 2 * size};
  }

  std::vector<std::vector<PackedVoxel>> memory_;
  std::vector<Bin> bins_;
};

}  // namespace ocelli
