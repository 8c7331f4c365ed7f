// A conservative footprint (section 6.1.3.1): pixels that hold every image point of a triangle, for a pinhole and for
// every camera that displaces its image points.
//
// The part of the triangle that can have an image is projected with the reference pinhole, where its corners bound it.
// The camera then bounds the displacement over the box of that image and the depths of that part.
#pragma once

#include <cmath>

#include "oc_core/camera/distorted_pinhole.h"
#include "oc_core/render/frustum_clip.h"

namespace ocelli {

/// Cameras whose triangles have a footprint.
template <class C>
concept BoundedCamera = Camera<C> && requires(const C& camera, const ImageBox& box) {
  { referenceOf(camera) } -> std::same_as<const PinholeCamera&>;
  { longestDisplacementOf(camera) } -> std::convertible_to<float>;
  { displacementOver(camera, box, 0.0f, 0.0f) } -> std::same_as<ImageBox>;
};

/// Pixels (x0, y0) to (x1, y1), those included; empty where x1 < x0 or y1 < y0.
struct PixelBox {
  int x0 = 0;
  int y0 = 0;
  int x1 = -1;
  int y1 = -1;

  bool empty() const { return x1 < x0 || y1 < y0; }
  bool contains(int x, int y) const { return x >= x0 && x <= x1 && y >= y0 && y <= y1; }
};

/// What rounding, and a ray path that is a polyline where the ray is a curve, may add to an image point, pixels.
inline constexpr float kFootprintSlackPixels = 0.1f;

/// How far beyond the image borders an undistorted image point may lie that the camera brings inside, pixels.
template <BoundedCamera C>
float clipMargin(const C& camera) {
  return longestDisplacementOf(camera) + 2;
}

/// The part of a triangle, in the camera space of `reference`, that has an image within `margin` pixels of the borders:
/// the triangle as it is, where it lies within.
inline ClipPolygon partInView(const std::array<glm::vec3, 3>& triangle, const PinholeCamera& reference, float margin) {
  ClipPolygon whole;
  for (const glm::vec3& p : triangle) {
    const ImagePoint q = reference.imageFromCamera(p);
    if (!(p.z >= reference.view().zNear && p.z <= reference.view().zFar) || !(q.u >= -margin) || !(q.v >= -margin) ||
        !(q.u <= static_cast<float>(reference.width()) + margin) ||
        !(q.v <= static_cast<float>(reference.height()) + margin)) {
      return clipToFrustum(triangle, reference, margin);
    }
    whole.vertices[whole.count] = {p, whole.count == 1 ? 1.0f : 0.0f, whole.count == 2 ? 1.0f : 0.0f};
    ++whole.count;
  }
  return whole;
}

/// `triangle` is in the camera space of the reference pinhole. Pixels whose centres may be image points of it.
template <BoundedCamera C>
PixelBox footprint(const C& camera, const std::array<glm::vec3, 3>& triangle) {
  const PinholeCamera& reference = referenceOf(camera);
  const ClipPolygon polygon = partInView(triangle, reference, clipMargin(camera));
  if (polygon.count == 0) {
    return {};
  }
  ImageBox box{glm::vec2(1e30f), glm::vec2(-1e30f)};
  float minInverseZ = 1e30f;
  float greatestInverseZ = 0;
  for (size_t i = 0; i < polygon.count; ++i) {
    const ImagePoint q = reference.imageFromCamera(polygon.vertices[i].p);
    box.lower = glm::min(box.lower, glm::vec2(q.u, q.v));
    box.upper = glm::max(box.upper, glm::vec2(q.u, q.v));
    minInverseZ = std::min(minInverseZ, 1 / q.t);
    greatestInverseZ = std::max(greatestInverseZ, 1 / q.t);
  }
  const ImageBox displacement = displacementOver(camera, box, minInverseZ, greatestInverseZ);
  const glm::vec2 lower = box.lower + displacement.lower - kFootprintSlackPixels;
  const glm::vec2 upper = box.upper + displacement.upper + kFootprintSlackPixels;
  const auto firstCentre = [](float lowest) { return static_cast<int>(std::ceil(std::max(lowest, 0.0f) - 0.5f)); };
  const auto lastCentre = [](float highest, int count) {
    return static_cast<int>(std::floor(std::min(highest, static_cast<float>(count)) - 0.5f));
  };
  return {firstCentre(lower.x), firstCentre(lower.y), lastCentre(upper.x, camera.width()),
          lastCentre(upper.y, camera.height())};
}

}  // namespace ocelli
