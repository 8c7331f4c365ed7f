// The stretches of cameras of the graph camera family (stretch.h): the frusta of a graph camera, and what lies before,
// between and behind the turns of a curved ray camera.
#pragma once

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/camera/graph_camera.h"
#include "oc_core/render/stretch.h"

namespace ocelli {

/// The last frustum along the ray of each pixel: it tells which others the ray passes.
PixelLeaves leavesOf(const GraphCamera& camera);

/// The frusta as stretches. Those that no ray passes have no ends, and `endsOfLeaf` is -1 throughout.
std::vector<Stretch> stretchesOf(const GraphCamera& camera, const PixelLeaves& leaves);

/// One before each turn, and one behind the last. All rays are of one kind; in the order of pieces turns lie between.
std::vector<Stretch> stretchesOf(const CurvedRayCamera& camera);

}  // namespace ocelli
