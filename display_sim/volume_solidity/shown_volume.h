// A volume as a display is to show it: what of it has light, and how much.
//
// A display that emits hides nothing: of a CT everything glows through everything. What helps is to leave light out:
//   - that of what is even inside: light by the gradient (SweptSampling::fullLightGradient);
//   - a cutaway: what lies on the viewers' side of a plane that faces them;
//   - what viewers would not see, were the volume as opaque as its transfer function says: an occlusion camera's image
//   of
//     it, in place of the volume (volume_sight.h). For viewers who move, or for several, from all their eyes.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "display_sim/volume_slicing/swept_light.h"
#include "display_sim/volume_slicing/swept_samples.h"
#include "display_sim/volume_slicing/volume_slicer.h"
#include "oc_core/volume_render/volume_renderer.h"

namespace ocelli {

struct ShownVolumeOptions {
  SweptSampling sampling{};
  SweptLightOptions light{};
  std::optional<double>
      surface{};  ///< show the surface at this value alone, in the hue that it has, at full brightness
  /// Shown where this volume has a value of 0.5 or more at the nearest voxel. In the scene's world; none: everywhere.
  std::shared_ptr<const VolumeScene> mask{};
  std::vector<glm::vec3> eyes{};        ///< of the viewers, in display radii, outside of the unit sphere
  std::optional<double> cutaway{};      ///< dark where the way towards an eye, from the centre, is longer than this
  std::optional<double> seenOpacity{};  ///< dark where every eye has this opacity before it
};

class ShownVolume {
 public:
  /// `scene` is in display radii; its clips count, its surfaces do not. Throws InputError for eyes in the display.
  ShownVolume(VolumeScene scene, const DisplayProfile& profile, const ShownVolumeOptions& options,
              const Progress& progress = {});

  /// With its clips and its cutaways. Of a surface, with a transfer function that shows that alone.
  const VolumeScene& scene() const { return scene_; }
  /// The same without what the mask and the shown values leave out (masked_volume.h), as that hides nothing: what eyes
  /// would see of it, were it opaque.
  VolumeScene seenScene() const;
  const SweptSamples& samples() const { return *samples_; }
  const SweptLight& light() const { return *light_; }

  /// The light of another transfer function: what to slice the samples with as it moves. What viewers do not see stays
  /// that of the first one. Of a surface its colour alone changes.
  SweptLight lightOf(const TransferFunction& transfer) const;

 private:
  SweptSamples::Part partOf(const ShownVolumeOptions& options, const Progress& progress) const;

  VolumeScene scene_;
  ShownVolumeOptions options_;
  std::unique_ptr<SweptSamples> samples_;
  std::unique_ptr<SweptLight> light_;
};

/// Throws InputError where no surface of the volume has this value. `where` names the volume.
void requireSurface(const VolumeScene& scene, double value, const std::string& where);

/// A transfer function that shows a surface alone: opaque where the field has the value, within a thousandth of the
/// range.
TransferFunction surfaceTransfer(double value, const glm::dvec3& color, const ValueRange& range, double opacityLength);

}  // namespace ocelli
