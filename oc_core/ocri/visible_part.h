// The part of a mesh that can show near what an image shows. Construction renders the same scene many times with a
// camera that changes little; triangles far behind the visible surfaces need not be drawn again.
#pragma once

#include "oc_core/camera/ddoc_camera.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Keeps the triangles with a vertex that lies, in the depth image `seen` or in the image `distorted` of `camera`, in
/// front of or within some pixel footprints behind the farthest of the 3x3 samples around its image; empty samples
/// count as infinitely far. Triangles larger than a pixel are always kept. Vertices that no kept triangle names are
/// dropped.
Mesh visiblePart(const Mesh& mesh, const DdocCamera& camera, const Image<float>& seen, const Image<float>& distorted);

}  // namespace ocelli
