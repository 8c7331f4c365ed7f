// Volumes into slices, slowly and obviously: many points in each cell, in double precision. Tests compare the
// VolumeSlicer with it.
#pragma once

#include <glm/vec3.hpp>

#include "display_sim/dither/slice_options.h"
#include "display_sim/dither/voxel_colors.h"
#include "display_sim/frames/volume.h"
#include "display_sim/volume_slicing/swept_light.h"
#include "oc_core/base/progress.h"
#include "oc_core/volume/volume_scene.h"

namespace ocelli {

class VolumeSliceReference {
 public:
  /// `scene` is in display radii, and must outlive it. Each cell has `pointsASide`^3 points, spread evenly over its
  /// width, height and thickness, each with the weight of what it stands for.
  VolumeSliceReference(const VolumeScene& scene, const DisplayProfile& profile, int pointsASide,
                       const SweptLightOptions& options = {});

  /// By the formula of swept_light.h, of the points of the cell that lie in the volume's box, times the share of points
  /// that do. Without the light that shades the volume.
  glm::vec3 lightOf(int slice, int column, int row) const;
  /// Of all voxels that have any.
  VoxelColors colors(const Progress& progress = {}) const;
  Volume slice(const SliceOptions& options, const Progress& progress = {}) const;

 private:
  const VolumeScene& scene_;
  DisplayProfile profile_;
  SweepGeometry sweep_;
  int pointsASide_;
  SweptLightOptions options_;
  glm::dmat4 indexFromScene_;
};

/// Each voxel's levels, where a dither decides.
Volume ditheredVolume(const VoxelColors& colors, const DisplayProfile& profile, const SliceOptions& options);

}  // namespace ocelli
