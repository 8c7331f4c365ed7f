// A camera that displaces the image points of a pinhole camera (chapter 3): what the occlusion cameras have in common,
// and what the renderers that draw triangle by triangle (section 6.1) need to know of them.
#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {

/// An axis-aligned rectangle of the image, pixels, borders included.
struct ImageBox {
  glm::vec2 lower{0};
  glm::vec2 upper{0};
};

/// What the points of `box` times factors in [least, greatest] lie between.
inline ImageBox scaled(const ImageBox& box, float least, float greatest) {
  return {
      glm::min(glm::min(box.lower * least, box.lower * greatest), glm::min(box.upper * least, box.upper * greatest)),
      glm::max(glm::max(box.lower * least, box.lower * greatest), glm::max(box.upper * least, box.upper * greatest))};
}

/// `distort` maps the pinhole's image point to that of the camera, at the same depth. `longestDisplacement` holds for
/// every point with an image inside of the borders. `displacementOver` bounds the displacement of every undistorted
/// image point in a box whose 1/z lies in a range: never too tight.
template <class C>
concept DistortedPinhole = Camera<C> &&
    requires(const C& camera, const ImagePoint& undistorted, const ImageBox& box, float inverseZ) {
  { camera.reference() } -> std::same_as<const PinholeCamera&>;
  { camera.distort(undistorted) } -> std::same_as<ImagePoint>;
  { camera.longestDisplacement() } -> std::convertible_to<float>;
  { camera.displacementOver(box, inverseZ, inverseZ) } -> std::same_as<ImageBox>;
};

/// A pinhole is one that displaces nothing: these let renderers treat it alike.
inline const PinholeCamera& referenceOf(const PinholeCamera& camera) {
  return camera;
}
inline float longestDisplacementOf(const PinholeCamera&) {
  return 0;
}
inline ImageBox displacementOver(const PinholeCamera&, const ImageBox&, float, float) {
  return {};
}

template <DistortedPinhole C>
const PinholeCamera& referenceOf(const C& camera) {
  return camera.reference();
}
template <DistortedPinhole C>
float longestDisplacementOf(const C& camera) {
  return camera.longestDisplacement();
}
template <DistortedPinhole C>
ImageBox displacementOver(const C& camera, const ImageBox& undistorted, float minInverseZ, float greatestInverseZ) {
  return camera.displacementOver(undistorted, minInverseZ, greatestInverseZ);
}

}  // namespace ocelli
