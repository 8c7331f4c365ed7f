// Slicing at the rate of the display: from a mesh to the lit voxels of a swept-screen display.
//
// The surface is sampled, and a voxel that holds a sample is lit. In the coordinates of the sweep (sectors, columns
// from the axis, rows) every point of a triangle has a sample of it less than half a voxel away in each direction: the
// proof is in triangle_strips.h. So nothing leaks through a closed surface from face to face: where the segment between
// the centres of two voxels that share a face meets the surface, the sample next to that point is in one of the two.
// The samples are corners; larger triangles get more of them, each by itself, whatever its neighbours, in strips along
// its longest side. What would need too many is found exactly (exact_triangle.h): triangles that are very large, lie
// near to the axis, or reach beyond the display.
//
// This lights fewer voxels than the definition of a lit voxel does (exact_slicer.h): not those that the surface just
// grazes. It lights none that sliceExactly() does not, but for what lies next to a border. Rounding takes a sample into
// the neighbour within about 1e-4 voxels. And a column is measured along its slice, a sample from the axis: beside the
// middle of its sector a sample is up to 1 - cos(pi / 2N) of its radius farther out, at the rim of the reference
// display 0.012 columns. With antialiasing the two share light at other points of a voxel.
//
// The same bytes with any number of threads and on every processor: threads gather lit voxels by slice, and then each
// slice is put together by one of them; the highest level of a voxel stays, in any order of the samples.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "display_sim/dither/slice_options.h"
#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/volume.h"
#include "display_sim/slicing/slice_mesh.h"
#include "display_sim/slicing/slice_pass.h"

namespace ocelli {

/// Slices meshes for one display, one after the other. Keeps its memory, so slicing a second time is faster.
class Slicer {
 public:
  explicit Slicer(const DisplayProfile& profile, const SliceOptions& options = {});
  ~Slicer();
  Slicer(Slicer&&) noexcept;

  const DisplayProfile& profile() const;

  /// What lies outside of the display is cut off. The volume stays the slicer's, until it slices again.
  const Volume& slice(const SliceMesh& mesh);

  /// Only these slices, as slice() makes them; the others stay as they were, dark in a new volume.
  const Volume& slice(const SliceMesh& mesh, std::span<const int> slices);

  /// The same volume as slice() gives, where `mesh` is what was sliced last, perhaps with other positions: only slices
  /// that moved triangles touch now, or touched before, are made again.
  const Volume& update(const SliceMesh& mesh);
  /// How many slices the last call made, and how long its stages took.
  int slicesMade() const;
  const SliceStages& stages() const;

  /// The volume; the slicer gets a new one.
  Volume takeVolume();
  /// The same, for others that only look at it: as soon as nobody holds it any more the slicer uses its memory again.
  std::shared_ptr<const Volume> takeShared();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Once: `mesh` is validated, its positions in display radii.
Volume slice(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options = {});

/// What the slicer's loops were compiled for, on this processor: "AVX2", for example.
std::string sliceInstructionSet();

}  // namespace ocelli
