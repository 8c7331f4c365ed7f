// Which values of a volume the codes of the display's voxels tell apart (swept_code.h).
//
// Codes have 1024 steps of the mean. One voxel of metal, or a value that stands for "nothing was measured", may lie a
// thousand times farther away than all others, and would leave these a single step. So the steps are spread over the
// values that are common and over those where the transfer function changes, and what lies beyond counts as the
// nearest of them: there the transfer function is constant.
#pragma once

#include <vector>

#include "oc_core/volume/scalar_volume.h"
#include "oc_core/volume/transfer_function.h"

namespace ocelli {

/// The volume's median, and the values of all but one in a hundred of the voxels that differ from it, as most of many
/// volumes is one background; half of what is left out lies on each side. Of large volumes, of every n-th voxel. Where
/// too few differ to tell, the range of all.
ValueRange commonValues(const ScalarVolume& volume);

/// Where a transfer function changes: from its first point to its last one that differs from what is constant beyond.
/// Empty where it is the same everywhere.
std::vector<double> valuesOfChange(const TransferFunction& transfer);

/// The values to tell apart, within `all`: `common` with half of its width on both sides, and each of `wanted` with a
/// margin, so that what is cut off never counts as one of them.
ValueRange codedRange(const ValueRange& all, const ValueRange& common, const std::vector<double>& wanted);

}  // namespace ocelli
