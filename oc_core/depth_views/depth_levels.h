// Depths as levels of 16 bits: 0 where nothing is seen, and 1 to 65535 in equal steps of z or of 1/z.
#pragma once

#include <array>
#include <cstdint>

namespace ocelli {

/// What equal steps of levels are equal steps of.
struct DepthScale {
  const char* name;
  const char* meaning;
  float (*scaleFromZ)(float z);
  float (*zFromScale)(float value);
};

inline constexpr int kMaxDepthLevel = 65535;

/// The first one is what is taken where nothing is said.
const std::array<DepthScale, 2>& depthScales();
inline const char* nameOf(const DepthScale& scale) {
  return scale.name;
}

/// Level 1 stands for `near` where `scale` grows with z, and for `far` where it falls.
struct DepthLevels {
  const DepthScale* scale = nullptr;
  float near = 0;
  float far = 0;

  /// 0 for level 0, and else a z from near to far.
  float zOf(uint16_t level) const;
  /// The nearest level, of depths beyond near and far that of these; 0 for a z of 0.
  uint16_t levelOf(float z) const;
};

}  // namespace ocelli
