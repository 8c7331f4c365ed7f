// What a lit voxel sends to the eye.
//
// Evenly: into all directions the same, as a display would that had no screen.
//
// From a screen: the voxel is a patch of a diffuse, semitransparent sheet (dissertation section 3.5.5.6). It is lit
// from one side, its front, which scatters light back; what comes through leaves the back. Both faces are diffuse
// (Lambertian): as bright from every side, so that their light is in proportion to the image area of the patch, which
// falls with the cosine between the screen's normal n and the direction to the eye, and is 0 where the screen is seen
// from its edge. With p from the eye to the voxel and z along the view direction, a pass sends
//   pi / 2 |n p| / z  x  2 / (1 + T) from the front,  x  2 T / (1 + T) from the back,
// of the light that evenly emitting voxels send. T is how much of the front's light the back has; the factors are such
// that the mean over a turn, seen from afar at the height of the display, is 1: what a lamp gives evenly is what a
// screen redistributes.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "display_sim/observing/exposure.h"
#include "oc_core/base/conventions.h"

namespace ocelli {

enum class EmissionModel {
  kEven,
  kScreen,
};

struct Emission {
  EmissionModel model = EmissionModel::kEven;
  double transmission = 1;  ///< T: of a screen, light of its back relative to that of its front
};

/// The light of a voxel on a part of the sweep, for eyes on either side of the screen's plane.
struct ArcLight {
  double ahead = 0;   ///< for eyes on the side of (-sin t, 0, cos t), where the screen's front looks at t in [0, 2 pi)
  double behind = 0;  ///< for eyes on the other side
};

/// `stepRadians` is the arc of a slice. Without the factor for the direction to the eye.
inline ArcLight arcLight(const ExposedArc& arc, const Emission& emission, double stepRadians) {
  const double share = (arc.toRadians - arc.fromRadians) / stepRadians;
  if (emission.model == EmissionModel::kEven) {
    return {arc.passes * share, arc.passes * share};
  }
  const double front = 2 / (1 + emission.transmission);
  const double back = emission.transmission * front;
  const double straight = arc.passes - arc.turnedPasses;
  return {share * (straight * front + arc.turnedPasses * back), share * (straight * back + arc.turnedPasses * front)};
}

/// The light of a voxel at `p` in eye coordinates; `along` is (-sin t, 0, cos t) there.
inline double lightTowardsEye(const ArcLight& light, EmissionModel model, const glm::dvec3& along,
                              const glm::dvec3& p) {
  if (model == EmissionModel::kEven) {
    return light.ahead;
  }
  const double slope = glm::dot(along, p) / p.z;
  return kPi / 2 * std::abs(slope) * (slope < 0 ? light.ahead : light.behind);
}

}  // namespace ocelli
