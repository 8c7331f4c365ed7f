// Where the plane of a slice cuts a volume.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/volume_slicing/swept_samples.h"

namespace ocelli {

/// A point at the signed distance r from the axis, s across the slice and the height y has the index coordinates
/// origin + byRadius r + byAcross s + byHeight y.
struct SweptPlane {
  SweptPlane(const glm::dmat4& indexFromScene, const SweepGeometry& sweep, int slice);

  glm::dvec3 origin;
  glm::dvec3 byRadius;
  glm::dvec3 byAcross;
  glm::dvec3 byHeight;
};

/// The bricks of the screen whose cells the volume's box may cover some of, and none where it lies beside them. The box
/// reaches from (-0.5, -0.5, -0.5) to `upper`, in index coordinates.
SweptSlice sweptOutline(const SweptPlane& plane, const glm::dvec3& upper, const SweepGeometry& sweep);

}  // namespace ocelli
