#include "display_driver/devices/voxel_grid.h"

#include <algorithm>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr int kBitsOfChannel[3] = {3, 3, 2};
constexpr int kShiftOfChannel[3] = {5, 2, 0};

/// A level of `shown` bits at the top of a channel of `bits` bits, repeated below.
unsigned widen(unsigned level, int shown, int bits) {
  unsigned wide = 0;
  for (int shift = bits - shown; shift > -shown; shift -= shown) {
    wide |= shift >= 0 ? level << shift : level >> -shift;
  }
  return wide;
}

}  // namespace

uint8_t rgb332(const glm::u64vec3& light, uint64_t full, int shownBits) {
  OC_CHECK(shownBits >= 1 && shownBits <= kMaxShownBits && full > 0, "no such display");
  const uint64_t most = std::max({light.r, light.g, light.b});
  OC_CHECK(most <= full, "more than full light");
  uint64_t levels[3];
  uint64_t any = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const uint64_t steps = (uint64_t{1} << std::min(shownBits, kBitsOfChannel[channel])) - 1;
    levels[channel] = (2 * light[channel] * steps + full) / (2 * full);
    any |= levels[channel];
  }
  unsigned color = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const bool rescued = any == 0 && most > 0 && light[channel] == most;
    const auto level = static_cast<unsigned>(rescued ? 1 : levels[channel]);
    const int bits = kBitsOfChannel[channel];
    color |= widen(level, std::min(shownBits, bits), bits) << kShiftOfChannel[channel];
  }
  return static_cast<uint8_t>(color);
}

ShownLevels shownLevels(uint8_t color, int shownBits) {
  ShownLevels shown{};
  for (int channel = 0; channel < 3; ++channel) {
    const int bits = kBitsOfChannel[channel];
    const int kept = std::min(shownBits, bits);
    shown.full[channel] = (1 << kept) - 1;
    shown.level[channel] = color >> (kShiftOfChannel[channel] + bits - kept) & shown.full[channel];
  }
  return shown;
}

}  // namespace ocelli
