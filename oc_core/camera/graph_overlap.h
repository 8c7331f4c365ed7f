// Whether the frusta of a graph camera are disjoint (section 4.1): a point that two frusta hold is seen by the first of
// them only, so what the other one shows of it is missing from projections, though its rays meet it.
//
// Frusta are compared by their convex pieces (frustum_pieces.h). An overlap counts where a ball fits in that touches
// no side of either piece: frusta that share a plane touch, and rounding lets them overlap by nothing that matters.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/camera/graph_camera.h"

namespace ocelli {

struct FrustumOverlap {
  int first = 0;
  int second = 0;       ///< it comes after the first
  glm::dvec3 point{0};  ///< that both hold
};

/// Diameter of the smallest ball that counts as an overlap, relative to the diagonal of the world.
inline constexpr double kMinOverlap = 1e-4;

/// The pairs of frusta that overlap within the box of a world, such as the bounds of a scene; in order, each once. What
/// lies beyond zFar counts as well. Throws InputError where the box is empty, a point or not finite, and where
/// `minOverlap` is not positive or not finite.
std::vector<FrustumOverlap> overlapsOf(const GraphCamera& camera, const glm::dvec3& lower, const glm::dvec3& upper,
                                       double minOverlap = kMinOverlap);

/// Throws InputError as well where there are such pairs, naming the first and a point that both hold.
void checkDisjoint(const GraphCamera& camera, const glm::dvec3& lower, const glm::dvec3& upper,
                   double minOverlap = kMinOverlap);

}  // namespace ocelli
