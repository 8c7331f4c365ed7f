// The triangle mesh of a reference image whose rows are epipolar lines, each stretched by itself (section 3.5.1): the
// sample below one of its own surface lies in the next row, but at another column.
//
// Samples are joined along their row. Each sample has a partner in the next row, the one nearest to it undistorted;
// where partners follow each other, the stretches of the two rows between them are closed with triangles. Samples that
// keep the order of columns only are partners, so that rows never cross.
#pragma once

#include "oc_core/ocri/image_mesh.h"

namespace ocelli {

/// World coordinates, linear colours. Vertices come in pixel order, first the samples, then the corners of squares at
/// the rims of surfaces. `pixelOfVertex` receives the index of the pixel that each vertex comes from.
Mesh rowMesh(const ReferenceImage& image, const ImageMeshOptions& options = {},
             std::vector<uint32_t>* pixelOfVertex = nullptr);

}  // namespace ocelli
