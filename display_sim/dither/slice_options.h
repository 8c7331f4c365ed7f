// What every slicer is told.
#pragma once

namespace ocelli {

/// How the light of a surface becomes levels of the display. All keep full light fully lit and none dark.
enum class ColorReduction {
  kDither,     ///< ordered dithering (dither.h)
  kBlueNoise,  ///< dithering with the mask of blue_noise.h
  kDiffusion,  ///< errors are passed on from voxel to voxel (diffusion.h): slow, for sliceExactly() alone
  kNearest,    ///< each voxel's nearest level
  kOccupancy,  ///< a channel has full light where it has any light
};

struct SliceOptions {
  ColorReduction colors = ColorReduction::kDither;
  /// A sample between two slices lights both, in proportion to how near it is.
  bool angularAntialiasing = false;
  /// Within this radius of the axis, in display radii, surfaces of all directions get the same light for their area, at
  /// the cost of that light (even_light.h). 0: every voxel gets the light of its surface. kOccupancy takes no notice.
  double evenLightRadius = 0;
};

/// What sliceExactly() alone can do.
inline bool needsExactSlicer(const SliceOptions& options) {
  return options.colors == ColorReduction::kDiffusion || options.evenLightRadius > 0;
}

/// What the GPU cannot do.
inline bool needsCpu(const SliceOptions& options) {
  return (options.colors != ColorReduction::kDither && options.colors != ColorReduction::kOccupancy) ||
         options.angularAntialiasing || options.evenLightRadius > 0;
}

}  // namespace ocelli
