// What hides what in a volume, as a mesh: occlusion cameras are built from surfaces.
#pragma once

#include "oc_core/base/progress.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/render/ray_target.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The meshes of the depth images of what rays first hit, from the reference eye and from the eight corners of the view
/// cell of that side around it: all that the constructions of occlusion cameras look at, as far as those nine see it.
/// World coordinates; empty where no ray hits anything.
Mesh firstHitMesh(const RayTarget& target, const PinholeCamera& reference, float cellSideRadii,
                  const Progress& progress = {});

}  // namespace ocelli
