// The triangles of a block of pixels. Most triangles of a dense scene are hidden: what it takes to sort them by depth
// is kept for each, and what it takes to draw one is worked out when it is asked for.
#pragma once

#include <vector>

#include "oc_core/antialiasing/antialias_triangle.h"

namespace ocelli {

/// A triangle that a pixel may show: its number, and what its 1/z lies between there.
struct PixelTriangle {
  uint32_t number = 0;
  float nearest = 0;   ///< the greatest 1/z
  float farthest = 0;  ///< the least
  float extent = 0;    ///< the longer side of the box around it, pixels of the reference
};

class BlockTriangles {
 public:
  /// Forgets all; keeps the memory.
  void start(const glm::ivec2& base);
  /// Returns its number. Not after prepared() was called.
  uint32_t add(uint32_t triangle, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
    kept_.push_back({{a, b, c}, triangle, kNotYet});
    return static_cast<uint32_t>(kept_.size() - 1);
  }
  /// Asks memory for one that prepared() will be called for soon.
  void expect(uint32_t number) const {
    __builtin_prefetch(&kept_[number]);
    __builtin_prefetch(&kept_[number].prepared);
  }
  /// None where it covers no area. Valid until start().
  const AntialiasTriangle* prepared(uint32_t number) {
    Kept& kept = kept_[number];
    if (kept.prepared == kNotYet) {
      prepare(kept);
    }
    return kept.prepared == kNone ? nullptr : &prepared_[kept.prepared];
  }

 private:
  static constexpr uint32_t kNotYet = 0xffffffffu;
  static constexpr uint32_t kNone = 0xfffffffeu;

  struct Kept {
    std::array<RasterVertex, 3> corners;
    uint32_t triangle;
    uint32_t prepared;  ///< where in prepared_
  };

  void prepare(Kept& kept);

  glm::ivec2 base_{0};
  std::vector<Kept> kept_;
  std::vector<AntialiasTriangle> prepared_;  ///< has room for all before it has the first: addresses stay
};

}  // namespace ocelli
