// Directions and planes as a plan shows them: turned about the axis that it looks along.
#pragma once

#include "oc_core/frustum_editor/drawn_edits.h"

namespace ocelli {

/// The angle by which a direction on the paper has to turn to become another, in world terms: about viewAxisOf(side).
double angleOnPaper(PlanSide side, const glm::dvec3& from, const glm::dvec3& to);
glm::dvec3 turnedAbout(const glm::dvec3& direction, const glm::dvec3& axis, double radians);

/// The plane that holds two points of a plan at any depth: it stands upright on the paper. Its normal is on the side
/// that `ahead` points to. Throws InputError where the points coincide.
DrawnEditPlane planeAcross(PlanSide side, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& ahead);

/// The plane turned so that the direction from `fixed` to `end` becomes that to `to`; it holds `fixed`.
DrawnEditPlane turnedPlane(PlanSide side, const Plane& plane, const glm::dvec3& fixed, const glm::dvec3& end,
                           const glm::dvec3& to);

/// Clockwise from the north (-z) as seen from above; and above the level. Degrees.
double headingDegrees(const glm::dvec3& direction);
double pitchDegrees(const glm::dvec3& direction);
glm::dvec3 directionOf(double headingDegrees, double pitchDegrees);

}  // namespace ocelli
