// Ray casting along the rays of any camera: the reference for every other renderer (section 6.1.1). With its
// acceleration structure standing, its cost hardly grows with the scene. That is Embree's where the toolkit is built
// with it, and a tree of our own, some times slower, where not (OCELLI_WITH_EMBREE).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "oc_core/base/parallel.h"
#include "oc_core/camera/camera.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/render/ray_target.h"
#include "oc_core/render/sight_line.h"

namespace ocelli {

/// A mesh prepared for intersection with the rays of any number of cameras. The mesh must outlive it.
class RayScene final : public RayTarget {
 public:
  enum class Quality {
    kLow,     ///< faster to build
    kMedium,  ///< faster to intersect
  };

  enum class Motion {
    kStill,
    kMoves,  ///< update() will be called; a little slower to build and to intersect
  };

  explicit RayScene(const Mesh& mesh, Quality quality = Quality::kMedium, Motion motion = Motion::kStill);
  ~RayScene() override;
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  enum class Update { kRefitted, kRebuilt };
  /// The vertices of the mesh stand elsewhere now; its triangles are the same, and it has as many vertices. The boxes
  /// of the structure follow, which is some ten times faster than to build it; where that has made it too bad
  /// (refit_quality.h), it is built anew. Nothing may intersect meanwhile. For scenes that move alone.
  Update update();

  const Mesh& mesh() const;
  /// The element is the triangle.
  std::optional<Hit> hit(const RayPath& ray) const override;
  void hits(std::span<const RayPath> rays, std::span<std::optional<Hit>> found) const override;

  /// The first triangle that the polyline meets, with its barycentric weights and the t of the polyline. Coordinates
  /// that are not finite meet nothing.
  Fragment intersect(const RayPath& path) const;
  /// The same for each of many paths, in packets: neighbours should run alike.
  void intersect(std::span<const RayPath> paths, std::span<Fragment> fragments) const;
  /// How far along each line a triangle is first met, as a share of its way; infinity where none is. In packets:
  /// neighbours should run alike. Lines whose coordinates are not finite meet nothing.
  void meet(std::span<const SightLine> lines, std::span<float> shares) const;
  /// The same with what is met there: t is the share.
  void meet(std::span<const SightLine> lines, std::span<Fragment> fragments) const;
  /// Around all triangles; empty as boundsOf() of an empty mesh.
  Box bounds() const override;
  /// Whether a point of the surface lies within `reach` of `point`.
  bool hasSurfaceNear(const glm::vec3& point, float reach) const;

  struct SurfacePoint {
    glm::vec3 position{0};
    uint32_t triangle = 0;
  };
  /// The point of the surface that is closest to `point`, where one lies within `reach`; of triangles that are equally
  /// close the first.
  std::optional<SurfacePoint> closestSurface(const glm::vec3& point, float reach) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What the ray path of each pixel centre meets first. On all threads.
FragmentImage castRays(int width, int height, const RayScene& scene,
                       const std::function<RayPath(const glm::vec2& pixel)>& rayPath);

/// The rays of a camera whose type is not known, and where it sees a point.
struct CameraRays {
  int width = 0;
  int height = 0;
  std::function<RayPath(const glm::vec2& pixel)> ray;
  /// Empty for cameras that see whatever their rays meet, at the parameter where they do.
  std::function<std::optional<ImagePoint>(const glm::vec3& worldPoint)> project;
};

/// The camera must outlive it.
template <Camera C>
CameraRays raysOfCamera(const C& camera) {
  return {camera.width(), camera.height(), [&camera](const glm::vec2& pixel) { return camera.rayPath(pixel); },
          [&camera](const glm::vec3& worldPoint) { return camera.project(worldPoint); }};
}

/// Gives fragments that were cast the t of their point's image, where that lies in their pixel, and takes out those
/// whose point has no image; where `known` covers a pixel, its fragment is taken as it is. Where `project` is empty,
/// they stay as they were cast.
void takeProjected(FragmentImage& fragments, const FragmentImage& known,
                   const std::function<std::optional<ImagePoint>(const glm::vec3&)>& project, const Mesh& mesh);

/// As below, but for the pixels that `known` covers: those are not cast.
FragmentImage raycast(const CameraRays& rays, const Mesh& mesh, const RayScene& scene, const FragmentImage& known);

template <Camera C>
FragmentImage raycast(const C& camera, const Mesh& mesh, const RayScene& scene, const FragmentImage& known) {
  return raycast(raysOfCamera(camera), mesh, scene, known);
}

/// The closest fragment along the ray path of each pixel centre.
template <Camera C>
FragmentImage raycast(const C& camera, const Mesh& mesh, const RayScene& scene) {
  return raycast(camera, mesh, scene, FragmentImage(camera.width(), camera.height()));
}

}  // namespace ocelli
