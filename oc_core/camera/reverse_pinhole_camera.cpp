#include "oc_core/camera/reverse_pinhole_camera.h"

#include "oc_core/base/error.h"
#include "oc_core/camera/straight_ray.h"

namespace ocelli {
namespace {

constexpr char kReversePinhole[] = "reverse pinhole camera";

}  // namespace

ReversePinholeCamera::ReversePinholeCamera(const PinholeCamera& reference, float sameImageDepth, float meetingDepth)
    : reference_(reference), sameImageDepth_(sameImageDepth), meetingDepth_(meetingDepth) {
  const float zNear = reference.view().zNear;
  const float zFar = reference.view().zFar;
  if (!std::isfinite(meetingDepth) || !(sameImageDepth >= zNear) || !(sameImageDepth <= zFar) ||
      !(meetingDepth > zFar)) {
    throw InputError("its depths are out of order", kReversePinhole,
                     "choose z_near <= depth of the same image <= z_far < depth where the rays meet");
  }
  const float least = magnificationAt(zNear);
  const float greatest = magnificationAt(zFar);
  if (!(least * kWidestOpening >= 1) || !(greatest <= kWidestOpening)) {
    throw InputError("its range of depths is too wide: its image would shrink or grow by more than a hundred",
                     kReversePinhole, "move \"z_near\" and \"z_far\" of the view towards the scene");
  }
  // u - u_u = (u - u_c) (1 - 1 / magnification), for u within the borders.
  const glm::vec2 center = reference.centerPixels();
  const glm::vec2 size(reference.width(), reference.height());
  const float halfDiagonal = glm::length(glm::max(glm::abs(center), glm::abs(size - center)));
  longestDisplacement_ = halfDiagonal * std::max(std::abs(1 - 1 / least), std::abs(1 - 1 / greatest));
}

ReversePinholeCamera ReversePinholeCamera::around(const PinholeCamera& reference, std::span<const glm::vec3> points) {
  View view = reference.view();
  float nearest = view.zFar;
  float farthest = 0;
  for (const glm::vec3& point : points) {
    const std::optional<ImagePoint> q = reference.project(point);
    if (q && q->u >= 0 && q->v >= 0 && q->u <= static_cast<float>(reference.width()) &&
        q->v <= static_cast<float>(reference.height())) {
      nearest = std::min(nearest, q->t);
      farthest = std::max(farthest, q->t);
    }
  }
  if (farthest == 0) {
    throw InputError("no point of what it looks around is in view", kReversePinhole, "turn the view towards it");
  }
  // A hundredth wider, so that rounding leaves no point out.
  const float middle = (nearest + farthest) / 2;
  view.zNear = nearest * 0.99f;
  view.zFar = std::min(farthest * 1.01f, (farthest + 2 * middle) / 2);
  return {PinholeCamera(view, reference.width(), reference.height()), middle, 2 * middle};
}

std::optional<ImagePoint> ReversePinholeCamera::project(const glm::vec3& worldPoint) const {
  const std::optional<ImagePoint> undistorted = reference_.project(worldPoint);
  if (!undistorted) {
    return std::nullopt;
  }
  const ImagePoint q = distort(*undistorted);
  return std::isfinite(q.u) && std::isfinite(q.v) ? std::optional(q) : std::nullopt;
}

std::optional<glm::vec3> ReversePinholeCamera::unproject(const ImagePoint& q) const {
  if (!reference_.unproject(q)) {  // not finite, or out of the depth range
    return std::nullopt;
  }
  const glm::vec2 center = reference_.centerPixels();
  const glm::vec2 undistorted = center + (glm::vec2(q.u, q.v) - center) / magnificationAt(q.t);
  return reference_.unproject({undistorted.x, undistorted.y, q.t});
}

RayPath ReversePinholeCamera::rayPath(const glm::vec2& pixel) const {
  return straightRay(*this, pixel, reference_.view());
}

ImageBox ReversePinholeCamera::displacementOver(const ImageBox& undistorted, float minInverseZ,
                                                float greatestInverseZ) const {
  const glm::vec2 center = reference_.centerPixels();
  return scaled({undistorted.lower - center, undistorted.upper - center}, magnificationAt(1 / greatestInverseZ) - 1,
                magnificationAt(1 / minInverseZ) - 1);
}

}  // namespace ocelli
