// What codecs ask about the bit planes of a slice (volume.h says how these lie in memory).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "display_sim/frames/display_profile.h"

namespace ocelli {

bool isDark(std::span<const uint8_t> planes);
bool areEqual(std::span<const uint8_t> a, std::span<const uint8_t> b);

/// Words of four bytes that are not 0.
struct WordCounts {
  uint32_t lit = 0;      ///< of the slice
  uint32_t changed = 0;  ///< of the difference
};

/// Fills `difference` with a XOR b, all of one length, and counts the words of `a` and of `difference`.
WordCounts subtract(std::span<const uint8_t> a, std::span<const uint8_t> b, std::span<uint8_t> difference);

/// planes = planes XOR difference.
void addDifference(std::span<uint8_t> planes, std::span<const uint8_t> difference);

/// Finds bits that are set beyond the width of a display's rows, where they must be 0.
class PaddingCheck {
 public:
  explicit PaddingCheck(const DisplayProfile& profile);

  bool holds(std::span<const uint8_t> planes) const;

 private:
  size_t rowBytes_;
  uint8_t mask_;  ///< of the bits of a row's last byte that lie beyond the width
};

}  // namespace ocelli
