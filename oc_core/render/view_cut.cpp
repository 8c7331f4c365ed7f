#include "oc_core/render/view_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace ocelli {
namespace {

/// The frustum of a pinhole whose eye may be anywhere within a ball.
class WideFrustum {
 public:
  WideFrustum(const PinholeCamera& camera, const ViewCutOptions& options)
      : camera_(camera), reach_(options.reach), pixelsPerError_(camera.focalPixels() / options.maxErrorPixels) {
    const float f = camera.focalPixels();
    const glm::vec2 center = camera.centerPixels();
    const float left = center.x + options.marginPixels;
    const float top = center.y + options.marginPixels;
    const float right = static_cast<float>(camera.width()) - center.x + options.marginPixels;
    const float bottom = static_cast<float>(camera.height()) - center.y + options.marginPixels;
    sides_ = {glm::normalize(glm::vec3(f, 0, left)), glm::normalize(glm::vec3(-f, 0, right)),
              glm::normalize(glm::vec3(0, f, top)), glm::normalize(glm::vec3(0, -f, bottom))};
    // Something out of place by e, in the worst direction and in the corner, moves its image by this times f e / z.
    const float x = std::max(left, right) / f;
    const float y = std::max(top, bottom) / f;
    obliqueness_ = std::sqrt(1 + x * x + y * y);
  }

  bool meets(const Sphere& sphere) const {
    const glm::vec3 p = camera_.cameraFromWorld(sphere.center);
    const float r = sphere.radius + reach_;
    return p.z + r >= camera_.view().zNear && p.z - r <= camera_.view().zFar &&
           std::all_of(sides_.begin(), sides_.end(), [&](const glm::vec3& side) { return glm::dot(side, p) >= -r; });
  }

  bool isCloseEnough(const Sphere& sphere, float error) const {
    const float z = camera_.cameraFromWorld(sphere.center).z - sphere.radius - reach_;
    return error * pixelsPerError_ * obliqueness_ <= std::max(z, camera_.view().zNear);
  }

 private:
  const PinholeCamera& camera_;
  float reach_;
  float pixelsPerError_;
  float obliqueness_ = 1;
  std::array<glm::vec3, 4> sides_{};  ///< inward normals, in camera coordinates
};

/// All of the scene, by its distance from a ball of eyes.
std::vector<ClusterChoice> cutAllAround(const PackedScene& scene, const PinholeCamera& camera,
                                        const ViewCutOptions& options) {
  // Of a panorama whose image is as large, a pixel takes up more than that.
  const float pixelsPerRadian = std::max(camera.focalPixels(), static_cast<float>(camera.width()) / 2);
  const float pixelsPerError = pixelsPerRadian / options.maxErrorPixels;
  const glm::vec3 eye = camera.eye();
  return chooseClusters(
      scene, [](const Sphere&) { return true; },
      [&](const Sphere& sphere, float error) {
        const float distance = glm::distance(sphere.center, eye) - sphere.radius - options.reach;
        return error * pixelsPerError <= std::max(distance, camera.view().zNear);
      });
}

}  // namespace

std::vector<ClusterChoice> viewCut(const PackedScene& scene, const PinholeCamera& camera,
                                   const ViewCutOptions& options) {
  if (options.allAround) {
    return cutAllAround(scene, camera, options);
  }
  const WideFrustum frustum(camera, options);
  return chooseClusters(
      scene, [&](const Sphere& sphere) { return frustum.meets(sphere); },
      [&](const Sphere& sphere, float error) { return frustum.isCloseEnough(sphere, error); });
}

}  // namespace ocelli
