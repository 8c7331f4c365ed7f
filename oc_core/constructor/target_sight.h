// Whether a curved ray camera shows a target that other objects may hide (section 4.3.1.3), decided by boxes around
// the objects in one of two ways:
//
//   rays    how many of the rays to points of the target's box meet no other box before.
//   images  how much of the target's image stays free of the images of the others, each image taken as the upright
//           rectangle around the projection of its box. That is the text's test. It takes less time, and it hides more:
//           a rectangle is larger than what is in it.
//
// The target may be taken larger, so that it is shown clear of the others: by a share of its size, or by pixels as in
// the text.
//
// DEVIATION: the text intersects all rectangles; here only objects nearer than the middle of the target hide it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/scene/box.h"

namespace ocelli {

/// By so much the target is taken larger on each side.
struct TargetMargin {
  double share = 0;   ///< of the size of its box, along each axis
  double pixels = 0;  ///< of its image; where rays decide, of a pinhole's image at the distance of its middle
};

struct TargetSight {
  const char* name;
  const char* description;
  /// The share of the target, from 0 to 1, that the camera shows.
  double (*share)(const CurvedRayCamera& camera, std::span<const Box> occluders, const Box& target,
                  const TargetMargin& margin);
};

/// The first is the usual one.
const std::vector<TargetSight>& targetSights();

/// Throws InputError where there is none of that name.
const TargetSight& targetSight(const std::string& name);

/// "rays" without a margin: the share of the points of a box, evenly spaced in it, that rays reach before they meet one
/// of the others.
double visibleShare(const CurvedRayCamera& camera, std::span<const Box> occluders, const Box& target);

/// The upright rectangle around the image of a box, pixels, and how near it is.
struct BoxImage {
  glm::dvec2 lower{0};
  glm::dvec2 upper{0};
  double nearest = 0;  ///< t of its nearest point
  bool whole = false;  ///< all of the box has an image, within the borders
};

/// Nothing where no point of the box has an image. Points along the edges are projected, as edges may be curves.
std::optional<BoxImage> imageOfBox(const CurvedRayCamera& camera, const Box& box);

}  // namespace ocelli
