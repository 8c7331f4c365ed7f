// Which views an image covers (section 5.2.1.2): what it takes for a picture of a view to need no other image.
//
// Three numbers, each 1 at the end of what is covered, and growing on from there:
//
//   reach   how far the corners of the view lie out in the image: the larger of |u - W/2| / (W/2) and |v - H/2| / (H/2)
//           over the four corners, each where the corner's direction meets the pinhole that the image is made of.
//           Infinite where one lies behind it. A view is convex, so its corners are enough.
//   detail  leastDetail / (samples of the image for a pixel of the view, in the middle of the view). There the image
//   has
//           rate(q) focal(image) / focal(view) samples a pixel, where q is the place of the middle in the image, and
//           rate that of gpc_map.h. Beyond the image, that of its border.
//   shift   how far the eye has moved: the larger of two. By how much near things have moved before far ones, in
//   heights
//           of the view, |eye - eye(image)| (1/near - 1/far) focal(view) / height, by largestParallax: so wide are the
//           strips that were hidden. And by which angle near things are seen from another side, |eye - eye(image)| /
//           near, by largestAngle. A twentieth of the samples are nearer than `near`, and a twentieth farther than
//           `far` (z). Infinite without depth. 0 from the image's own eye.
#pragma once

#include <algorithm>
#include <glm/vec2.hpp>

#include "oc_core/camera/gpc_map.h"
#include "oc_core/ocri/reference_image.h"

namespace ocelli {

/// Where the samples of an image lie.
struct DepthSpan {
  double nearZ = 0;  ///< 0 where nothing is known
  double farZ = 0;

  double inverseSpan() const { return nearZ > 0 ? 1 / nearZ - 1 / farZ : 0; }
};
DepthSpan depthSpanOf(const ReferenceImage& image);

/// What there is of an image before its samples have come.
struct ImageCover {
  PinholeCamera reference;
  GpcMap map;
  DepthSpan depths;  ///< without depth: nothing known

  ImageCover(const PinholeCamera& pinhole, const GpcLayout& layout, const DepthSpan& span = {})
      : reference(pinhole), map(layout, pinhole.width(), pinhole.height()), depths(span) {}
  /// Without `hasDepth` what the image says of its depth does not count.
  explicit ImageCover(const ReferenceImage& image, bool hasDepth = true);
};

struct CoverLimits {
  double leastDetail = 0.7;       ///< samples for a pixel in the middle of a view
  double largestParallax = 0.06;  ///< between near and far things, heights of the view
  double largestAngle = 0.1;      ///< by which near things are seen from another side, radians
};

struct CoverLoad {
  double reach = 0;
  double detail = 0;
  double shift = 0;

  double whole() const { return std::max({reach, detail, shift}); }
  bool isCovered() const { return whole() <= 1; }
  /// Covered, and from the image's own eye: nothing is hidden that the view shows.
  bool isExact() const { return shift == 0 && isCovered(); }
};

/// `screen` is the size of the view in pixels.
CoverLoad coverLoad(const ImageCover& image, const View& view, const glm::ivec2& screen, const CoverLimits& limits);
CoverLoad coverLoad(const ImageCover& image, const PinholeCamera& view, const CoverLimits& limits);

}  // namespace ocelli
