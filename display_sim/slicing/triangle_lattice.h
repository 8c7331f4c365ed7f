// Where a triangle is sampled: the points of a lattice that divides its sides into n equal parts, without its corners.
#pragma once

#include <cstdint>
#include <vector>

namespace ocelli {

/// Weights of the corners for lattices of up to kMaxParts, with and without each side.
class TriangleLattices {
 public:
  static constexpr int kMaxParts = 32;

  struct Range {
    uint32_t first = 0;
    uint32_t count = 0;
  };

  TriangleLattices();

  /// `parts` in [2, kMaxParts]; bit k of `sidesLeftOut`: the side from corner k to the next, without its samples.
  const Range& range(int parts, unsigned sidesLeftOut) const {
    return ranges_[static_cast<unsigned>(parts) * 8 + sidesLeftOut];
  }
  const float* weights1() const { return weights1_.data(); }
  const float* weights2() const { return weights2_.data(); }
  const float* weights3() const { return weights3_.data(); }

 private:
  std::vector<Range> ranges_;
  std::vector<float> weights1_;
  std::vector<float> weights2_;
  std::vector<float> weights3_;
};

/// A triangle of a lattice that spans so much in each direction has no point half a voxel away from all its corners:
/// two thirds of its span is the most (in its middle, where each corner is the farthest in one direction).
inline constexpr float kWidestCell = 0.74f;

}  // namespace ocelli
