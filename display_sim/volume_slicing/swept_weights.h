// How much of its light each voxel of the display gives, in 255ths, by bricks: a brick whose voxels all give full light
// keeps no weights, and is sliced without them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ocelli {

inline constexpr int kSweptBrickSide = 8;
inline constexpr size_t kSweptBrickVoxels = size_t{kSweptBrickSide} * kSweptBrickSide;

class SweptWeights {
 public:
  using Brick = std::array<uint8_t, kSweptBrickVoxels>;

  /// The weights of some bricks, in their order: what a thread makes.
  class Some {
   public:
    /// Keeps nothing where all are 255.
    void add(size_t brick, const Brick& weights);

   private:
    friend class SweptWeights;
    std::vector<size_t> bricks_;
    std::vector<uint8_t> weights_;
  };

  /// Full light of every voxel.
  SweptWeights() = default;
  /// Of so many bricks, of which some may be in one of the parts each.
  SweptWeights(size_t bricks, const std::vector<Some>& parts);

  /// Those of a brick, row by row; nullptr where all of its voxels give full light.
  const uint8_t* of(size_t brick) const {
    return places_.empty() || places_[brick] == kFull ? nullptr : weights_.data() + places_[brick] * kSweptBrickVoxels;
  }
  bool areFull() const { return weights_.empty(); }
  size_t bytes() const { return weights_.size() + places_.size() * sizeof(uint32_t); }

 private:
  static constexpr uint32_t kFull = 0xffffffff;

  std::vector<uint32_t> places_;  ///< by brick: which of those that have weights; empty where none has
  std::vector<uint8_t> weights_;
};

}  // namespace ocelli
