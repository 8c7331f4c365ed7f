// Ray casting along the rays of any camera, with Embree: slow, obvious, and the reference for every other renderer
// (section 6.1.1).
#pragma once

#include <functional>
#include <memory>

#include "oc_core/camera/camera.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

/// A mesh prepared for intersection. The mesh must outlive it.
class RayScene {
 public:
  explicit RayScene(const Mesh& mesh);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// The first triangle that the polyline meets, with its barycentric weights; `z` is left 0.
  Fragment intersect(const RayPath& path) const;
  /// Whether a point of the surface lies within `reach` of `point`.
  bool hasSurfaceNear(const glm::vec3& point, float reach) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// For each pixel, `fragmentAt(x, y)`, on all threads.
FragmentImage castPixels(int width, int height, const std::function<Fragment(int x, int y)>& fragmentAt);

/// The closest fragment along the ray path of each pixel centre.
template <Camera C>
FragmentImage raycast(const C& camera, const Mesh& mesh, const RayScene& scene) {
  return castPixels(camera.width(), camera.height(), [&](int x, int y) {
    Fragment fragment = scene.intersect(camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
    if (fragment.covered()) {
      const std::optional<ImagePoint> q = camera.project(positionOf(fragment, mesh));
      fragment = q ? Fragment{q->z, fragment.triangle, fragment.b1, fragment.b2} : Fragment{};
    }
    return fragment;
  });
}

}  // namespace ocelli
