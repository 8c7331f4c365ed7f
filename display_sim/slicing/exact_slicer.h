// Exact slicing: from a mesh to the lit voxels of a swept-screen display.
//
// A voxel is lit iff the surface passes through its cell, faces included (sweep_geometry.h), so closed meshes are
// watertight in the voxels, and the axis, where every sector meets, and the wrap from the last slice to the first need
// no exception. Within a sector the cells are convex with flat faces; that makes the test exact: clip the triangle to
// the sector, drop it on the plane of the slice, and find the pixel squares that the polygon touches.
//
// Colour: the colour of a triangle at one of its points inside the voxel, reduced to the display's levels
// (slice_options.h). Where several surfaces pass through one voxel, it shows the highest level in each channel. A black
// surface lights nothing.
#pragma once

#include <span>

#include "display_sim/dither/slice_options.h"
#include "display_sim/dither/voxel_colors.h"
#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/volume.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// `mesh` is validated, its positions in display radii; what lies outside of the display is cut off. The same bytes
/// with any number of threads. Equals sliceReference() but for cells whose faces lie within kSliceRounding of the
/// surface.
Volume sliceExactly(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options = {});

/// Only these slices; the others are dark. Not with error diffusion, which passes errors from slice to slice.
Volume makeSlicesExactly(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options,
                         std::span<const int> slices);

/// The colours of the voxels that sliceExactly() lights, weighed for even light, before they are reduced to levels;
/// black ones are left out. Takes 16 bytes a voxel, and about as much again on the way.
VoxelColors colorsExactly(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options = {});

/// Only of these slices.
VoxelColors colorsOfSlices(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options,
                           std::span<const int> slices);

/// How far, in columns, rounding may move a cell's face, for coordinates of at most one display radius: some tens of
/// operations in double precision on screen coordinates of at most 4096. Grows in proportion with larger coordinates.
inline constexpr double kSliceRounding = 1e-9;

}  // namespace ocelli
