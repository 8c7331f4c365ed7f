// sliceExactly() on the GPU: the same voxels, cell by cell, in compute shaders.
//
// A first pass gives each triangle to one invocation, which clips it to the sectors it may touch and lights the pixel
// squares that its parts touch. The parts of larger triangles are queued instead, and a second pass gives each part to
// one invocation, so that neither a wall over all slices nor a triangle at the axis holds up the rest.
#pragma once

#include <algorithm>

#include "display_sim/gl/gl_volume.h"
#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/gl/gl_mesh.h"

namespace ocelli {

enum class GlPrecision {
  /// The operations of sliceExactly() in their order: the same bits wherever the GPU rounds as IEEE 754 does. Where it
  /// does
  /// not, cells whose faces lie within kSliceRounding of the surface may differ.
  kDouble,
  /// For GPUs that are slow at double precision: cells whose faces lie within singleSliceRounding() of the surface may
  /// differ, on scanned objects fewer than one in ten thousand of the lit ones. Closed surfaces stay closed.
  kSingle,
};

/// kSliceRounding's like in single precision.
inline double singleSliceRounding(const DisplayProfile& profile) {
  // Some tens of operations, each of which rounds by 2^-24 of a coordinate, and the slack of slicer.glsl.
  return 2e-6 * std::max(profile.width, profile.height);
}

class GlSlicer {
 public:
  /// Throws GlError where the driver refuses a shader.
  explicit GlSlicer(GlContext& context, GlPrecision precision = GlPrecision::kDouble);

  /// Replaces what `volume` holds. The mesh and the volume are of this context; positions in display radii.  Throws
  /// GlError where it has no room.
  void slice(const GlMesh& mesh, GlVolume& volume, const SliceOptions& options = {});

 private:
  void makeRoom(size_t items);
  /// Returns how many items belong into the queue, which may be more than it has room for.
  size_t sliceSmall(size_t triangles);
  void sliceLarge(size_t queued);

  GlContext* context_;
  GlPrecision precision_;
  GlObject small_;
  GlObject large_;
  GlObject directions_;  ///< of the sectors of so many slices
  int slices_ = 0;
  GlObject queue_;
  size_t queueRoom_ = 0;
};

}  // namespace ocelli
