// The definition of a lit voxel, executed: every triangle is clipped to every cell that its bounds touch. Slow and
// straightforward; sliceExactly() is tested against it.
#pragma once

#include "display_sim/slicing/exact_slicer.h"

namespace ocelli {

struct ReferenceOptions {
  /// Any but kDiffusion.
  ColorReduction colors = ColorReduction::kDither;
  /// Every cell's faces are moved outwards by this much, in columns and rows; negative shrinks the cells. Brackets what
  /// rounding may do to another slicer.
  double margin = 0;
  double evenLightRadius = 0;  ///< as in SliceOptions
};

/// Colour: that of the triangle at the mean of the corners of its part in the voxel.
Volume sliceReference(const Mesh& mesh, const DisplayProfile& profile, const ReferenceOptions& options = {});

}  // namespace ocelli
