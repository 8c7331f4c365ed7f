// Rasterisation for the planar pinhole camera: project the vertices, fill the triangles (section 6, introduction).
#pragma once

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/render/projected_mesh.h"

namespace ocelli {

/// The closest fragment at each pixel of `camera`. Triangles are clipped to the frustum; both sides are drawn.
FragmentImage rasterize(const PinholeCamera& camera, const Mesh& mesh);
/// The same for the camera of a mesh that has been projected.
FragmentImage rasterize(const ProjectedMesh& projected);

}  // namespace ocelli
