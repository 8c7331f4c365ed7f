// The slicer that one writes first: one thread, triangle by triangle; a peer for slicer_bench.
#pragma once

#include "display_sim/frames/volume.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// For each plane that lies between the angles of a triangle's corners, the segment in which they meet is drawn into
/// the slice. So what lies along a plane, or between two, is lost. No colour.
Volume sliceNaively(const Mesh& mesh, const DisplayProfile& profile);

}  // namespace ocelli
