#include "display_sim/frames/bit_planes.h"

#include <algorithm>
#include <cstring>

namespace ocelli {

bool isDark(std::span<const uint8_t> planes) {
  return planes.front() == 0 && std::memcmp(planes.data(), planes.data() + 1, planes.size() - 1) == 0;
}

bool areEqual(std::span<const uint8_t> a, std::span<const uint8_t> b) {
  return std::memcmp(a.data(), b.data(), a.size()) == 0;
}

WordCounts subtract(std::span<const uint8_t> a, std::span<const uint8_t> b, std::span<uint8_t> difference) {
  WordCounts counts;
  // Words of four bytes, which compilers compare several at a time.
  const auto step = [&](size_t at, size_t bytes) {
    uint32_t wordOfA = 0;
    uint32_t wordOfB = 0;
    std::memcpy(&wordOfA, a.data() + at, bytes);
    std::memcpy(&wordOfB, b.data() + at, bytes);
    const uint32_t change = wordOfA ^ wordOfB;
    std::memcpy(difference.data() + at, &change, bytes);
    counts.lit += wordOfA != 0 ? 1 : 0;
    counts.changed += change != 0 ? 1 : 0;
  };
  const size_t whole = a.size() / sizeof(uint32_t) * sizeof(uint32_t);
  for (size_t at = 0; at < whole; at += sizeof(uint32_t)) {
    step(at, sizeof(uint32_t));
  }
  if (whole < a.size()) {
    step(whole, a.size() - whole);
  }
  return counts;
}

void addDifference(std::span<uint8_t> planes, std::span<const uint8_t> difference) {
  std::ranges::transform(planes, difference, planes.begin(),
                         [](uint8_t a, uint8_t b) { return static_cast<uint8_t>(a ^ b); });
}

PaddingCheck::PaddingCheck(const DisplayProfile& profile)
    : rowBytes_((static_cast<size_t>(profile.width) + 7) / 8),
      mask_(static_cast<uint8_t>(profile.width % 8 == 0 ? 0 : 0xff << (profile.width % 8))) {}

bool PaddingCheck::holds(std::span<const uint8_t> planes) const {
  for (size_t last = rowBytes_ - 1; mask_ != 0 && last < planes.size(); last += rowBytes_) {
    if ((planes[last] & mask_) != 0) {
      return false;
    }
  }
  return true;
}

}  // namespace ocelli
