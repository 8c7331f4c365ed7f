// A volume as occlusion cameras see it: the surface of a volume is where the opacity of what a ray has passed first
// reaches a threshold. Every camera that builds reference images builds them of it (oc_core/ocri/camera_choice.h), and
// evaluation measures them (oc_core/evaluation/evaluation.h).
//
// This surface depends on the ray: a thick haze is hit deeper in by a ray that enters it at its thin end. Each
// viewpoint's truth is what its own rays hit, so representations err by that as well, where a volume is not as good as
// opaque at the threshold.
//
// Layers, of layered depth images: behind a hit a ray passes on until it is in the clear (volume_matter.h), and the
// next layer is what it hits from there, by its own opacity again. So layers are what lies behind what, as those of
// meshes are, and not the inside of the first thing.
//
// DEVIATION: the text has no occlusion cameras of volumes; it renders volumes along the rays of other cameras.
#pragma once

#include <string>

#include "oc_core/evaluation/evaluated_scene.h"
#include "oc_core/render/target_renderer.h"
#include "oc_core/volume_ocri/volume_matter.h"
#include "oc_core/volume_render/volume_renderer.h"
#include "oc_core/volume_render/volume_target.h"

namespace ocelli {

class VolumeFirstHits {
 public:
  /// Reads all voxels once. `options.depthOpacity` is the threshold.
  explicit VolumeFirstHits(VolumeScene scene, const VolumeRenderOptions& options = {});
  VolumeFirstHits(const VolumeFirstHits&) = delete;
  VolumeFirstHits& operator=(const VolumeFirstHits&) = delete;

  const VolumeScene& scene() const { return renderer_.scene(); }
  const RayTarget& target() const { return target_; }
  double opacity() const { return renderer_.options().depthOpacity; }

  /// For buildReferenceImages(): one for each set of images, as it keeps what it has hit. Must not outlive this.
  TargetRenderer renderer() const { return TargetRenderer(target_, behind()); }
  /// For Evaluator. Must not outlive this.
  TargetScene evaluated() const;

  /// For titles: "256 x 256 x 108 voxels, first hits at an opacity of 0.5".
  std::string description() const;
  /// Tells it from other volumes, appearances and thresholds: a hash of all of them.
  std::string identity() const;

 private:
  TargetRenderer::Behind behind() const;

  VolumeRenderer renderer_;
  VolumeTarget target_;
  VolumeMatter matter_;
};

}  // namespace ocelli
