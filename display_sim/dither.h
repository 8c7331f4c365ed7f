// Ordered dithering of linear colours to one bit a channel.
//
// Source: the additive recurrence of M. Roberts, "The unreasonable effectiveness of quasirandom sequences" (2018): the
// powers of 1/phi_3, phi_3^4 = phi_3 + 1, make a lattice whose every line and plane samples [0, 1) evenly, so a
// surface of any direction through the voxels is dithered evenly. A matrix that repeats (Bayer's) has planes
// that meet only a few of its thresholds.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace ocelli {

/// Strictly between 0 and 1: full light is always lit, none never. Depends on the voxel alone.
inline float ditherThreshold(int slice, int column, int row) {
  // 2^32 / phi_3, / phi_3^2, / phi_3^3
  const uint32_t sum = static_cast<uint32_t>(column) * 3518319155u + static_cast<uint32_t>(row) * 2882110345u +
                       static_cast<uint32_t>(slice) * 2360945575u;
  return (static_cast<float>(sum >> 9) + 0.5f) * 0x1p-23f;
}

/// Bit 0 red, bit 1 green, bit 2 blue: lit where the channel exceeds the voxel's threshold.
inline unsigned ditheredBits(const glm::vec3& color, int slice, int column, int row) {
  const float threshold = ditherThreshold(slice, column, row);
  return (color.x > threshold ? 1u : 0u) | (color.y > threshold ? 2u : 0u) | (color.z > threshold ? 4u : 0u);
}

/// Lit where the channel has any light at all.
inline unsigned occupancyBits(const glm::vec3& color) {
  return (color.x > 0 ? 1u : 0u) | (color.y > 0 ? 2u : 0u) | (color.z > 0 ? 4u : 0u);
}

}  // namespace ocelli
