// Ordered dithering of linear colours to the levels of a display.
//
// Source: the additive recurrence of M. Roberts, "The unreasonable effectiveness of quasirandom sequences" (2018): the
// powers of 1/phi_3, phi_3^4 = phi_3 + 1, make a lattice whose every line and plane samples [0, 1) evenly, so a
// surface of any direction through the voxels is dithered evenly. A matrix that repeats (Bayer's) has planes
// that meet only a few of its thresholds.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "oc_core/base/png_file.h"

namespace ocelli {

/// Strictly between 0 and 1: full light is always lit, none never. Depends on the voxel alone.
inline float ditherThreshold(int slice, int column, int row) {
  // 2^32 / phi_3, / phi_3^2, / phi_3^3
  const uint32_t sum = static_cast<uint32_t>(column) * 3518319155u + static_cast<uint32_t>(row) * 2882110345u +
                       static_cast<uint32_t>(slice) * 2360945575u;
  return (static_cast<float>(sum >> 9) + 0.5f) * 0x1p-23f;
}

/// Between two levels the higher one is taken where the channel's rest exceeds the threshold. `light` is clamped to
/// [0, 1].
inline uint8_t ditheredLevel(float light, int fullLevel, float threshold) {
  const float scaled = (light > 0 ? light < 1 ? light : 1.0f : 0.0f) * static_cast<float>(fullLevel);
  const int lower = static_cast<int>(scaled);
  return static_cast<uint8_t>(lower + (scaled - static_cast<float>(lower) > threshold ? 1 : 0));
}

inline Rgb8 ditheredLevels(const glm::vec3& color, int fullLevel, int slice, int column, int row) {
  const float threshold = ditherThreshold(slice, column, row);
  return {ditheredLevel(color.x, fullLevel, threshold), ditheredLevel(color.y, fullLevel, threshold),
          ditheredLevel(color.z, fullLevel, threshold)};
}

/// Full light where the channel has any light at all.
inline Rgb8 occupancyLevels(const glm::vec3& color, int fullLevel) {
  const auto full = static_cast<uint8_t>(fullLevel);
  return {color.x > 0 ? full : uint8_t{0}, color.y > 0 ? full : uint8_t{0}, color.z > 0 ? full : uint8_t{0}};
}

}  // namespace ocelli
