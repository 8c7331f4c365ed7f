// Error diffusion over the lit voxels of a sweep: what a voxel shows too much or too little is made up for by its
// neighbours in space.
//
// Source: R. Floyd and L. Steinberg, "An adaptive algorithm for spatial greyscale" (1976), on a serpentine path, with
// R. Ulichney's perturbed thresholds ("Digital halftoning", 1987), here those of dither.h: with a fixed threshold, and
// with less of a perturbation, diffusion starts late in dark parts and makes worms, and its block errors are larger.
// DEVIATION: voxels are decided slice after slice as the screen turns, and errors go both to those of the same slice
// and to those of the next, in proportion to 1 / d^2, where d is the distance of the voxels' centres in space. Near the
// axis the next slice's voxels of the same columns lie nearest, since consecutive slices meet there; far from it those
// of the same slice do.
//
// A channel passes errors only to voxels that have light between none and full in it: what is black stays dark, what is
// white is lit fully. An error that finds none of these within kDiffusionReach is left over, and reported.
#pragma once

#include <glm/vec3.hpp>

#include "display_sim/dither/voxel_colors.h"
#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/volume.h"

namespace ocelli {

inline constexpr int kDiffusionReach = 3;  ///< in columns and rows

struct Diffused {
  Volume volume;
  glm::dvec3 light{0};     ///< that the voxels should show together, in full voxels of each channel
  glm::dvec3 leftOver{0};  ///< the part of it that they don't: light is what the volume shows plus this
};

/// On one thread, from the first slice to the last; about a second for a million voxels. Lights above 1 count as 1.
Diffused diffuse(VoxelColors colors, const DisplayProfile& profile);

}  // namespace ocelli
