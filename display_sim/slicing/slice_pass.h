// One pass of the fast slicer (slicer.h) over chunks of a mesh.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "display_sim/dither/slice_options.h"
#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/volume.h"
#include "display_sim/slicing/slice_mesh.h"

namespace ocelli {

/// The sectors that a chunk may light: first, first + 1, ... modulo their number.
struct SectorSpan {
  int first = 0;
  int count = 0;
};

/// What a pass took, in milliseconds, and what it did.
struct SliceStages {
  double sampling = 0;    ///< finding the voxels of samples
  double exact = 0;       ///< finding the voxels of triangles that are found exactly
  double assembling = 0;  ///< clearing slices and putting them together
  size_t samples = 0;     ///< points of the surface, vertices included
  size_t exactCells = 0;  ///< cells of triangles that are found exactly
};

class SlicePass {
 public:
  virtual ~SlicePass() = default;

  /// Fills in those of `chunks` in `spans`, which has an element for each chunk of the mesh.
  virtual void findSpans(const SliceMesh& mesh, std::span<const size_t> chunks, std::span<SectorSpan> spans) = 0;

  /// The same, clears the slices of `wanted`, and lights what these chunks light in them.
  virtual SliceStages run(const SliceMesh& mesh, std::span<const size_t> chunks, std::span<const int> wanted,
                          std::span<SectorSpan> spans, Volume& volume) = 0;
};

std::unique_ptr<SlicePass> makeSlicePass(const DisplayProfile& profile, const SliceOptions& options);

}  // namespace ocelli
