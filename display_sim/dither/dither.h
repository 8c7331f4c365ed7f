// Ordered dithering of linear colours to the levels of a display.
//
// Source: the thresholds are a rank-1 lattice, as in the additive recurrence of M. Roberts, "The unreasonable
// effectiveness of quasirandom sequences" (2018). A matrix that repeats (Bayer's) has planes that meet only a few of
// its thresholds; a lattice has no such plane.
//
// The steps of the lattice come from a search. First, any block of 8 columns, 8 rows and 4 slices has thresholds that
// are spread almost evenly: sorted, each lies within 1.6 / 256 of its place in an even spread, and the mean error of
// the block's light is 0.46 / 255. (Lattices whose blocks are spread perfectly exist, but by a theorem of Hajos their
// lines in one of the three directions meet only 8, or 4, thresholds.) Then, as even as the first condition allows:
// smaller and larger boxes, planes, lines in 13 directions, and voxels of consecutive slices at one place of the
// screen, which near the axis lie at one place in space.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "oc_core/image/png_file.h"

namespace ocelli {

/// What one column, row or slice adds to a threshold, in 2^-32.
inline constexpr uint32_t kDitherColumnStep = 2686409057u;
inline constexpr uint32_t kDitherRowStep = 3288575657u;
inline constexpr uint32_t kDitherSliceStep = 1928973365u;

/// Strictly between 0 and 1: full light is always lit, none never. Depends on the voxel alone.
inline float ditherThreshold(int slice, int column, int row) {
  const uint32_t sum = static_cast<uint32_t>(column) * kDitherColumnStep + static_cast<uint32_t>(row) * kDitherRowStep +
                       static_cast<uint32_t>(slice) * kDitherSliceStep;
  return (static_cast<float>(sum >> 9) + 0.5f) * 0x1p-23f;
}

/// Between two levels the higher one is taken where the channel's rest exceeds the threshold. `light` is clamped to
/// [0, 1].
inline uint8_t ditheredLevel(float light, int fullLevel, float threshold) {
  const float scaled = (light > 0 ? light < 1 ? light : 1.0f : 0.0f) * static_cast<float>(fullLevel);
  const int lower = static_cast<int>(scaled);
  return static_cast<uint8_t>(lower + (scaled - static_cast<float>(lower) > threshold ? 1 : 0));
}

inline Rgb8 ditheredLevels(const glm::vec3& color, int fullLevel, float threshold) {
  return {ditheredLevel(color.x, fullLevel, threshold), ditheredLevel(color.y, fullLevel, threshold),
          ditheredLevel(color.z, fullLevel, threshold)};
}

inline Rgb8 ditheredLevels(const glm::vec3& color, int fullLevel, int slice, int column, int row) {
  return ditheredLevels(color, fullLevel, ditherThreshold(slice, column, row));
}

/// Full light where the channel has any light at all.
inline Rgb8 occupancyLevels(const glm::vec3& color, int fullLevel) {
  const auto full = static_cast<uint8_t>(fullLevel);
  return {color.x > 0 ? full : uint8_t{0}, color.y > 0 ? full : uint8_t{0}, color.z > 0 ? full : uint8_t{0}};
}

}  // namespace ocelli
