// A volume that ranks slice together: each makes the slices of its angles, rank 0 gathers them. The bytes are those of
// slice() and sliceExactly() for any number of ranks.
//
// Each rank has the whole mesh and makes it ready for slicing; what is divided is finding and lighting voxels. Error
// diffusion passes errors from slice to slice: there rank 0 gathers the colours of voxels, and diffuses them alone.
#pragma once

#include <vector>

#include "display_sim/dither/slice_options.h"
#include "display_sim/frames/volume.h"
#include "oc_core/ranks/ranks.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The stored slices of a rank: neighbours in angle, of both half turns where both are stored.
std::vector<int> slicesOfRank(const DisplayProfile& profile, int rank, int size);

/// The whole volume in rank 0; in the others their own slices alone, or nothing. By sliceExactly() where `exact`, or
/// the options need it.
Volume sliceTogether(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options, bool exact,
                     Ranks& ranks);

}  // namespace ocelli
