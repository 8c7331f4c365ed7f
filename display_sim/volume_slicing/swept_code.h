// What a voxel of the display keeps of the part of a volume that it covers: the mean of the field there, and how far
// the field spreads around it, in 16 bits.
//
// The values in a cell are taken as spread evenly over [mean - half, mean + half], with the variance that they have:
// half = sqrt(3 variance). For a field that is linear in the cell along one of its edges this is exact. Both are in
// shares of the volume's range of values: the mean in 1024 steps; the half spread in 62 steps, each 2^(1/5) times the
// one before, from a quarter of a step of the mean to more than the range.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ocelli {

inline constexpr int kSweptMeanBits = 10;
inline constexpr int kSweptMeans = 1 << kSweptMeanBits;
inline constexpr int kSweptSpreadBits = 6;
inline constexpr int kSweptSpreads = 1 << kSweptSpreadBits;
inline constexpr size_t kSweptCodes = size_t{1} << (kSweptMeanBits + kSweptSpreadBits);
/// Of a voxel that holds nothing of the volume.
inline constexpr uint16_t kNothingSwept = kSweptCodes - 1;

inline constexpr float kSweptSpreadsAnOctave = 5;
inline constexpr float kMinSweptSpread = 0.25f;  ///< in steps of the mean

/// Of the range, from 0 to 1.
inline constexpr float sweptMeanOf(uint16_t code) {
  return static_cast<float>(code >> kSweptSpreadBits) / (kSweptMeans - 1);
}

/// Of the range; 0 for the spread that is too small to be kept.
inline float sweptHalfSpreadOf(uint16_t code) {
  const int step = code & (kSweptSpreads - 1);
  return step == 0
             ? 0
             : kMinSweptSpread * std::exp2(static_cast<float>(step - 1) / kSweptSpreadsAnOctave) / (kSweptMeans - 1);
}

/// The logarithm to base 2 to within 0.01, of a positive, normal number.
inline float roughLog2(float x) {
  const auto bits = std::bit_cast<uint32_t>(x);
  const float mantissa = std::bit_cast<float>((bits & 0x007fffffu) | 0x3f800000u);
  const auto exponent = static_cast<float>(static_cast<int>(bits >> 23) - 127);
  return exponent + (mantissa - 1) * (1 + 0.346607f * (2 - mantissa));
}

/// `mean` and `halfSpread` are shares of the range; what exceeds it is cut off.
inline uint16_t sweptCode(float mean, float halfSpread) {
  constexpr auto kSteps = static_cast<float>(kSweptMeans - 1);
  const float inRange = std::clamp(mean, 0.0f, 1.0f);
  const auto step = static_cast<uint16_t>(inRange * kSteps + 0.5f);
  const float spread = halfSpread * kSteps / kMinSweptSpread;
  int spreadStep = 0;
  if (spread > 0.87f) {  // 2^(-1/5): nearer to the first step than to none
    spreadStep =
        std::clamp(1 + static_cast<int>(kSweptSpreadsAnOctave * roughLog2(spread) + 0.5f), 1, kSweptSpreads - 2);
  }
  return static_cast<uint16_t>((step << kSweptSpreadBits) | spreadStep);
}

}  // namespace ocelli
