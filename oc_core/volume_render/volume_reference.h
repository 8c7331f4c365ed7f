// Volumes along rays, slowly and obviously, in double precision: what every faster way is tested against.
#pragma once

#include "oc_core/camera/camera.h"
#include "oc_core/render/raycast.h"
#include "oc_core/volume/volume_scene.h"
#include "oc_core/volume_render/volume_image.h"
#include "oc_core/volume_render/volume_lighting.h"

namespace ocelli {

class VolumeReference {
 public:
  /// Steps are no longer than `step` mean distances of voxels. The scene must outlive it.
  explicit VolumeReference(const VolumeScene& scene, double step = 1.0 / 16, double depthOpacity = 0.5);

  /// In every step the field, the transfer function and the light are those of its middle. No step is left out.
  VolumePixel pixel(const RayPath& ray) const;

 private:
  const VolumeScene& scene_;
  double step_;
  double depthOpacity_;
  VolumeLighting lighting_;
  std::unique_ptr<RayScene> surfaces_;
};

template <Camera C>
VolumeImage renderReference(const C& camera, const VolumeScene& scene, double step = 1.0 / 16,
                            double depthOpacity = 0.5) {
  const VolumeReference reference(scene, step, depthOpacity);
  VolumeImage image(camera.width(), camera.height());
  parallelFor(static_cast<size_t>(image.height()), 1, [&](size_t begin, size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        image(x, y) = reference.pixel(camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
      }
    }
  });
  return image;
}

}  // namespace ocelli
