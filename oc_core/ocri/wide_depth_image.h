// A depth image that is wider than the reference view: what a user has who only widens the pinhole. It holds what the
// viewpoints of a cell see beside the reference frustum, and nothing of what is hidden.
#pragma once

#include "oc_core/ocri/reference_image.h"
#include "oc_core/ocri/view_cell.h"

namespace ocelli {

/// Times the image plane of `reference` has to grow, in width and height alike, to hold whatever of `mesh` lies in the
/// frusta of the viewpoints on the edges of `cell`, hidden or not; viewpoints inside see less far out than its corners
/// (a sphere bulges a little beyond those that stand for it). It grows with the side of the cell and the depths of what
/// lies beside the reference frustum: 1 where nothing does, as for a fitted scene in the default view. Throws
/// InputError where no image plane is wide enough: something that a viewpoint sees is nearer to the reference eye than
/// its zNear, beside it or behind it.
float wideFactor(const PinholeCamera& reference, const Mesh& mesh, const ViewCell& cell);

/// The depth image of the pinhole with the same eye, axis and focal length and `factor` times as many pixels each way,
/// rounded up so that its pixels fall onto those of the reference. `factor` is 1 or more; throws InputError for others,
/// and where the image would exceed the limits of PinholeCamera.
ReferenceImage buildWideDepthImage(const PinholeCamera& reference, const Mesh& mesh, float factor,
                                   const SceneRenderer* renderer = nullptr);

}  // namespace ocelli
