// Volumes along the rays of any camera: emission and absorption (transfer_function.h), integrated from near to far
// (sections 4.2.1 and 5.2).
//
// Rays are polylines (ray_path.h). Of each, what lies within the volume's box and its clips counts; where that is one
// piece, samples stand at equal distances along it, from where it begins, however it bends, and a last one where it
// ends. So light is lost and gained by length, and brightness does not change where rays bend. Between two samples the
// field is taken to be linear, and the transfer function is integrated over its values there (optical_table.h): a thin
// peak between two samples is not missed.
//
// DEVIATION: section 4.4.2 takes equal steps of the parameter of a transition's arc (Equation 4.1), as many as the
// length of its control polygon asks for. These are not equally long, and so the text's images are darker or brighter
// within a bend unless each is weighted by its length. Here steps are equally long.
//
// A surface ends a ray where it meets it. volume_reference.h does the same slowly, and obviously.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <span>

#include "oc_core/base/progress.h"
#include "oc_core/camera/camera.h"
#include "oc_core/camera/ray_hull.h"
#include "oc_core/camera/ray_smoothness.h"
#include "oc_core/volume/volume_scene.h"
#include "oc_core/volume_render/volume_image.h"

namespace ocelli {

struct VolumeRenderOptions {
  /// Distance of samples, as a multiple of the mean distance of voxels: positive. Half of the default changes pixels of
  /// smooth volumes by less than 1/255; docs/results.md ("Volumes along rays") has figures of others. Twice and four
  /// times of it are for pictures that move.
  double step = 0.25;
  /// A ray ends where no more than this share of the light behind would reach the eye: that is how wrong it may be.
  double endTransmittance = 1.0 / 1024;
  /// VolumePixel::t is where the opacity of what lies before reaches this: in (0, 1).
  double depthOpacity = 0.5;
  /// Do not look at samples where the transfer function shows nothing, by bricks of voxels. The pixels are the same,
  /// but for rounding.
  bool skipEmpty = true;
};

/// A volume prepared for the rays of any number of cameras. Safe to use from many threads while nothing is set.
class VolumeRenderer {
 public:
  /// Reads all voxels once, on all threads.
  explicit VolumeRenderer(VolumeScene scene, const VolumeRenderOptions& options = {});
  ~VolumeRenderer();
  VolumeRenderer(VolumeRenderer&&) noexcept;
  VolumeRenderer& operator=(VolumeRenderer&&) noexcept;

  const VolumeScene& scene() const;
  const VolumeRenderOptions& options() const;
  /// These read no voxels: milliseconds, for editors.
  void setAppearance(const VolumeAppearance& appearance);
  void setClips(std::vector<ClipPlane> clips);
  void setOptions(const VolumeRenderOptions& options);

  /// Of a ray without points, or with coordinates that are not finite, nothing.
  VolumePixel pixel(const RayPath& ray) const;
  /// The same for each of many rays, one entry of `pixels` a ray.
  void pixels(std::span<const RayPath> rays, std::span<VolumePixel> pixels) const;
  /// The pixel of each ray up to where its opacity reaches depthOpacity, or to a surface.
  void firstHits(std::span<const RayPath> rays, std::span<VolumePixel> pixels) const;

  /// The rays of the pixel centres, on all threads; the same bytes whatever their number. `progress` is called on the
  /// calling thread, and may throw to end the work. With the hull of the rays, those of parts of the image that see
  /// nothing are not made. With `isSmooth` (ray_smoothness.h) those of
  /// small parts of the image are placed between those of its corners where they are off by a thousandth of a voxel at
  /// most, and parts that see nothing are found by the bricks that they run through.
  VolumeImage render(int width, int height, const std::function<RayPath(const glm::vec2& pixel)>& rayPath,
                     const Progress& progress = {}, const RayHull& hull = {}, bool isSmooth = false) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

template <Camera C>
VolumeImage renderVolume(const C& camera, const VolumeRenderer& renderer, const Progress& progress = {}) {
  const std::shared_ptr<const C> borrowed(std::shared_ptr<const void>(), &camera);
  return renderer.render(
      camera.width(), camera.height(), [&](const glm::vec2& pixel) { return camera.rayPath(pixel); }, progress,
      rayHullOf(borrowed), kHasSmoothRays<C>);
}

template <Camera C>
VolumeImage renderVolume(const C& camera, const VolumeScene& scene, const VolumeRenderOptions& options = {},
                         const Progress& progress = {}) {
  return renderVolume(camera, VolumeRenderer(scene, options), progress);
}

}  // namespace ocelli
