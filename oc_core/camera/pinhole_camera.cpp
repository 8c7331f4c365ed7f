#include "oc_core/camera/pinhole_camera.h"

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/camera/straight_ray.h"

namespace ocelli {

PinholeCamera::PinholeCamera(const View& view, int width, int height) : view_(view), width_(width), height_(height) {
  validate(view, "view");
  if (width < 1 || height < 1 || width > kMaxPixelsASide || height > kMaxPixelsASide ||
      int64_t{width} * height > kMaxPixels) {
    throw InputError("an image of " + std::to_string(width) + "x" + std::to_string(height) + " pixels cannot be made",
                     "--size", "choose 1 to 32768 pixels a side, and 2^26 in all (8192x8192)");
  }
  forward_ = glm::normalize(view.target - view.eye);
  right_ = glm::normalize(glm::cross(forward_, view.up));
  down_ = glm::cross(forward_, right_);
  const double halfFov = radiansFromDegrees(view.resolvedFovVerticalDegrees()) / 2;
  focal_ = static_cast<float>(height / 2.0 / std::tan(halfFov));
  centerU_ = static_cast<float>(width) / 2 + view.centerShift.x * static_cast<float>(height);
  centerV_ = static_cast<float>(height) / 2 + view.centerShift.y * static_cast<float>(height);
}

RayPath PinholeCamera::rayPath(const glm::vec2& pixel) const {
  return straightRay(*this, pixel, view_);
}

}  // namespace ocelli
