// Volumes straight into slices, at the rate of the display while their transfer function moves.
//
// What the voxels of the display cover is sampled once (swept_samples.h). Each volume for the display is then a
// look-up: a voxel's 16 bits have a colour and an extinction, the column has the opacity of its thickness, the product
// is the light of three channels in one word (swept_light.h), and adding what is left of a dither's threshold to full
// light carries into the bit of each channel that is lit. Bricks in whose range of values nothing has light are left
// out.
//
// The same bytes with any number of threads: slices are made independently.
#pragma once

#include <memory>

#include "display_sim/dither/slice_options.h"
#include "display_sim/dither/voxel_colors.h"
#include "display_sim/frames/volume.h"
#include "display_sim/volume_slicing/swept_light.h"
#include "display_sim/volume_slicing/swept_samples.h"

namespace ocelli {

/// What of the options slicers of volumes do not have: the name of the first one that is set, or nullptr. Voxels are
/// averages in any case, and as bright near the axis as elsewhere.
const char* unfitForVolumes(const SliceOptions& options);

/// Slices one volume after the other for one display. Keeps its memory.
class VolumeSlicer {
 public:
  /// Options that unfitForVolumes() names must not be set. Error diffusion takes seconds.
  explicit VolumeSlicer(const DisplayProfile& profile, const SliceOptions& options = {});
  ~VolumeSlicer();
  VolumeSlicer(VolumeSlicer&&) noexcept;

  /// `samples` and `light` are for this display, and of one volume. The scene is turned about the axis by so many steps
  /// of the sweep, counter-clockwise seen from above. The volume stays the slicer's, until it slices again.
  const Volume& slice(const SweptSamples& samples, const SweptLight& light, int stepsTurned = 0);

  /// The volume; the slicer gets a new one.
  Volume takeVolume();
  /// The same, for others that only look at it: as soon as nobody holds it any more the slicer uses its memory again.
  std::shared_ptr<const Volume> takeShared();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The light of all voxels that have any, before a dither. What nothing is told of is 0.
VoxelColors sweptColors(const SweptSamples& samples, const SweptLight& light, int stepsTurned = 0);

/// The steps of the sweep that are nearest to an angle, for slice(). In display coordinates counter-clockwise seen from
/// above.
int stepsOfAngle(const SweepGeometry& sweep, double radians);

}  // namespace ocelli
