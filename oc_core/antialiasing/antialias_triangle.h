// A triangle, or the part of one that the view shows, ready to be tested at points of a block of pixels.
//
// Vertices are snapped to 1/4096 pixel of the reference's image. The constants of the edge functions are exact
// integers, rounded once; so triangles that share an edge evaluate it to the same number with opposite signs, and a
// point on the edge belongs to that for which it is a top or a left one: neither gaps nor points that count twice.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "oc_core/camera/distorted_pinhole.h"
#include "oc_core/render/visibility_buffer.h"

namespace ocelli {

/// a x + b y + c; x and y are pixels of the reference's image from the base of a block.
struct BlockPlane {
  float a = 0;
  float b = 0;
  float c = 0;

  float at(float x, float y) const { return a * x + b * y + c; }
  /// Of a box.
  float least(const ImageBox& box) const {
    return std::min(a * box.lower.x, a * box.upper.x) + std::min(b * box.lower.y, b * box.upper.y) + c;
  }
  float greatest(const ImageBox& box) const {
    return std::max(a * box.lower.x, a * box.upper.x) + std::max(b * box.lower.y, b * box.upper.y) + c;
  }
};

struct AntialiasTriangle {
  /// What edges that are neither top nor left ask for: more than 0.
  static constexpr float kAboveZero = std::numeric_limits<float>::min();

  std::array<BlockPlane, 3> edges;  ///< opposite of the corner of the same number; inside where at() >= `inside`
  std::array<float, 3> inside{};    ///< 0 or kAboveZero
  BlockPlane inverseZ;              ///< 1/z, linear over the image
  float perArea = 0;                ///< edges[i].at() * perArea: what corner i weighs in the image
  ImageBox box;                     ///< in the reference's image, from the base
  std::array<RasterVertex, 3> corners;
  uint32_t triangle = 0;

  /// Where its vertices have one colour, that.
  std::optional<glm::vec3> onlyColor(const Mesh& mesh) const;
  /// The linear colour at a point. Beyond its edges (multisampling) the nearest weights that lie within.
  glm::vec3 colorAt(float x, float y, const Mesh& mesh) const;
};

/// Fills `t` in. False where it covers no area. `base` is in whole pixels of the reference.
bool prepareTriangle(AntialiasTriangle& t, uint32_t triangle, const RasterVertex& a, const RasterVertex& b,
                     const RasterVertex& c, const glm::ivec2& base);

}  // namespace ocelli
