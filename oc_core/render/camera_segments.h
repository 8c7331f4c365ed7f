// The segments of cameras of the graph camera family (straight_segment.h): the frusta of a graph camera, and what lies
// before, between and behind the bends of a curved ray camera.
#pragma once

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/camera/graph_camera.h"
#include "oc_core/render/straight_segment.h"

namespace ocelli {

/// The last frustum along the ray of each pixel: it tells which others the ray passes.
PixelLeaves leavesOf(const GraphCamera& camera);

/// The frusta as segments. Those that no ray passes have no ends, and `endsOfLeaf` is -1 throughout.
std::vector<StraightSegment> segmentsOf(const GraphCamera& camera, const PixelLeaves& leaves);

/// One before each bend, and one behind the last. All rays are of one kind; in the order of pieces bends lie between.
std::vector<StraightSegment> segmentsOf(const CurvedRayCamera& camera);

}  // namespace ocelli
