// Colour and depth side by side: the other format that light-field displays take. One view, and for each pixel how near
// it is; the display's own software makes the views. What the view does not see is missing in all of them.
#pragma once

#include <string>
#include <vector>

#include "display_sim/quilt/quilt_images.h"

namespace ocelli {

/// Where the depth stands beside the colours, as the displays number it.
struct DepthSide {
  const char* name;
  int number;
  glm::ivec2 depthAt;  ///< of the two places, in sizes of one
  glm::ivec2 colorAt;
};
const std::vector<DepthSide>& depthSides();
/// Throws InputError, naming `where`, for other names.
const DepthSide& depthSideNamed(const std::string& name, const std::string& where);

struct ColorAndDepth {
  Image<Rgb8> color;
  /// 255 for what is nearest, 1 for what is farthest, in equal steps of 1/z; 0 where nothing is seen.
  Image<uint8_t> depth;
  float nearInverseZ = 0;
  float farInverseZ = 0;
};

/// What the middle view shows. `scene` is in the stretched world.
ReferenceImage middleDepthImage(const QuiltViews& views, const Mesh& scene);
ColorAndDepth colorAndDepth(const ReferenceImage& middle);
Image<Rgb8> pictureOf(const ColorAndDepth& pair, const DepthSide& side);

/// What a display can know from the pair: the middle view with depths of 8 bits.
ReferenceImage depthImageOf(const ColorAndDepth& pair, const QuiltViews& views);
/// The views that follow from a depth image of the middle view.
QuiltPicture quiltFromDepthImage(const QuiltViews& views, const ReferenceImage& middle,
                                 QuiltDepths depths = QuiltDepths::kNone);

}  // namespace ocelli
