// Depth discontinuities of a depth image: steps 1 and 2 of the DDOC's construction (section 3.2.2).
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/image/image.h"

namespace ocelli {

/// A place where a near surface ends before a far one.
struct DepthEdge {
  glm::vec2 position{0};  ///< pixels, on the border between the pixel of the occluder and that of the background
  glm::vec2 normal{0};    ///< unit, from the occluder towards the background
  float inverseNear = 0;  ///< 1/z of the occluder
  float inverseFar = 0;   ///< 1/z of the background
};

/// A step of z that is an edge in the variants that follow the text, display radii. The text has a threshold and does
/// not say which; a hundredth of the usual scene's depth is half of this.
inline constexpr float kPaperDepthStepRadii = 0.05f;

struct DepthEdgeOptions {
  /// A step of 1/z counts where it exceeds what the slopes on both of its sides explain by this much. Surfaces that are
  /// planes, however grazing, have constant slopes of 1/z.
  float minInverseZStep = 0;
  /// 1/z of pixels that no surface covers.
  float backgroundInverseZ = 0;
  /// Edge pixels this far away take part in the least-squares line that gives the normal, pixels.
  float lineFitRadiusPixels = 5;
  /// Where not 0: a step of z counts instead, where it exceeds what the slopes of z explain by this much, as in the
  /// text. World units.
  float minZStep = 0;
};

/// `inverseZ` holds 1/z, 0 where nothing is covered. Edges come in row order.
std::vector<DepthEdge> findDepthEdges(const Image<float>& inverseZ, const DepthEdgeOptions& options);

}  // namespace ocelli
