// The triangle mesh of a reference image (section 3.5.1): neighbouring samples are joined, except across depth
// discontinuities, and no sample is lost.
#pragma once

#include <limits>

#include "oc_core/ocri/reference_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

struct ImageMeshOptions {
  /// Neighbours are joined when their depths differ by at most this many pixel footprints (z / focal length), times the
  /// pixels between their undistorted places, taken as 1 to 1.5,
  float depthStepFootprints = 10;
  /// ... or by more, where 1/z goes on with the slope it has on one of the two sides, within this many footprints:
  /// grazing and stretched surfaces;
  float slopeToleranceFootprints = 1;
  /// ... but never when their undistorted places are farther apart than this, pixels.
  float longestStepPixels = 12;
  /// Placed samples (placed_image.h) are joined when their depths differ by at most so many footprints of their rays,
  /// or where the line through two of them goes on within slopeToleranceFootprints.
  float placedStepFootprints = 3;
  /// The sample at the rim of a surface stands for the whole of its pixel: it gets a square along the surface, of this
  /// side,
  float squarePixels = 1;
  /// ... or larger where a camera squeezes samples together, along with the distance between them, up to this.
  float longestSquarePixels = 4;
  /// ... but reaching at most so many footprints to the front and back. Seen by the camera itself, the square of a
  /// grazing surface is as small as any; from aside it stands out by as much as it is deep.
  float deepestSquareFootprints = std::numeric_limits<float>::infinity();
};

/// World coordinates, linear colours; none where the image has none. Vertices come in pixel order, first the samples,
/// then the corners of squares. Where the mesh would exceed `image.triangleBound`, squares become one triangle, and
/// then none, those of the least open samples first. `pixelOfVertex` receives the index of the pixel that each vertex
/// comes from.
Mesh imageMesh(const ReferenceImage& image, const ImageMeshOptions& options = {},
               std::vector<uint32_t>* pixelOfVertex = nullptr);

/// How many triangles that mesh has where nothing bounds them, of an image that displaces a pinhole's; without making
/// it.
size_t imageMeshTriangles(const ReferenceImage& image);

}  // namespace ocelli
