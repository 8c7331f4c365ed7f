// The triangle mesh of a reference image (section 3.5.1): neighbouring samples are joined, except across depth
// discontinuities, and no sample is lost.
#pragma once

#include "oc_core/ocri/reference_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

struct ImageMeshOptions {
  /// Neighbours are joined up to this distance between their undistorted places, pixels.
  float longestStepPixels = 3.5f;
  /// ... and up to this depth step, in pixel footprints for each pixel of distance,
  float depthStepFootprints = 10;
  /// ... or a larger one, where 1/z goes on with the slope it has on one of the two sides, within this many footprints.
  float slopeToleranceFootprints = 3;
  /// A sample at the rim of a surface stands for the whole of its pixel, so it gets a square along the surface, of this
  /// side.
  float squarePixels = 1.0f;
};

/// World coordinates, linear colours. Vertices come in pixel order, first the samples, then the corners of squares.
Mesh imageMesh(const ReferenceImage& image, const ImageMeshOptions& options = {});

}  // namespace ocelli
