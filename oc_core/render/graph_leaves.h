// Which frusta of a graph camera the ray of each pixel passes: the last of them, its leaf, tells all.
#pragma once

#include "oc_core/camera/graph_camera.h"
#include "oc_core/render/stretch.h"

namespace ocelli {

/// The last frustum along the ray of each pixel.
PixelLeaves leavesOf(const GraphCamera& camera);

/// The frusta as stretches. Those that no ray passes have no ends, and `endsOfLeaf` is -1 throughout.
std::vector<Stretch> stretchesOf(const GraphCamera& camera, const PixelLeaves& leaves);

}  // namespace ocelli
