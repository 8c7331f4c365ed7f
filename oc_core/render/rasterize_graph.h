// Rasterisation for the graph camera, frustum by frustum (section 4.1): triangles are clipped with a frustum, projected
// with its matrix and filled, as the image of one frustum is that of a pinhole.
//
// A ray meets what its first frustum holds before anything that later ones do, so at each pixel the sample of the
// frustum nearest to the root is kept. Within a frustum the closest fragment wins, the lower triangle index on a tie:
// the same image for any number of threads.
//
// DEVIATION: the triangles of a frustum are found by boxes around blocks of neighbouring triangles, instead of an
// octree: scenes come in a coherent order, and a box costs a few multiplications.
#pragma once

#include "oc_core/camera/graph_camera.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

/// The closest fragment along the ray of each pixel; both sides of triangles are drawn.
FragmentImage rasterize(const GraphCamera& camera, const Mesh& mesh);

}  // namespace ocelli
