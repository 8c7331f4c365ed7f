// Depth images from the corners of the view cell beside that of the reference view: the brute force way to see behind
// things.
#pragma once

#include "oc_core/ocri/reference_image.h"
#include "oc_core/ocri/view_cell.h"

namespace ocelli {

/// The reference depth image, then those of the cell's corners, all of one size and field of view, each looking at the
/// target. `corners` is 8 for all of them, or 4 for those of the face towards the scene: closer to it they look farther
/// behind things, and 4 in one plane cover left and right as well as above and below. Throws InputError for another
/// count, and for a cell that is no cube.
ReferenceImages buildCornerDepthImages(const PinholeCamera& reference, const Mesh& mesh, const ViewCell& cell,
                                       int corners, const SceneRenderer* renderer = nullptr);

}  // namespace ocelli
