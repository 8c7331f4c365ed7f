#include "oc_core/frustum_editor/plan_turns.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {

glm::dvec3 turnedAbout(const glm::dvec3& direction, const glm::dvec3& axis, double radians) {
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  return direction * c + glm::cross(axis, direction) * s + axis * (glm::dot(axis, direction) * (1 - c));
}

double angleOnPaper(PlanSide side, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 axis = viewAxisOf(side);
  const glm::dvec3 a = from - axis * glm::dot(axis, from);
  const glm::dvec3 b = to - axis * glm::dot(axis, to);
  return std::atan2(glm::dot(axis, glm::cross(a, b)), glm::dot(a, b));
}

DrawnEditPlane planeAcross(PlanSide side, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& ahead) {
  const glm::dvec3 normal = glm::cross(b - a, viewAxisOf(side));
  if (!(glm::length(normal) > 0)) {
    throw InputError("the stroke has no length", "plan", "drag from one side of the rays to the other");
  }
  return {(a + b) * 0.5, glm::normalize(glm::dot(normal, ahead) < 0 ? -normal : normal)};
}

DrawnEditPlane turnedPlane(PlanSide side, const Plane& plane, const glm::dvec3& fixed, const glm::dvec3& end,
                           const glm::dvec3& to) {
  return {fixed, turnedAbout(plane.normal, viewAxisOf(side), angleOnPaper(side, end - fixed, to - fixed))};
}

double headingDegrees(const glm::dvec3& direction) {
  const double degrees = degreesFromRadians(std::atan2(direction.x, -direction.z));
  return degrees < 0 ? degrees + 360 : degrees;
}

double pitchDegrees(const glm::dvec3& direction) {
  return degreesFromRadians(std::asin(std::clamp(direction.y / glm::length(direction), -1.0, 1.0)));
}

glm::dvec3 directionOf(double headingDegrees, double pitchDegrees) {
  const double heading = radiansFromDegrees(headingDegrees);
  const double pitch = radiansFromDegrees(pitchDegrees);
  return {std::sin(heading) * std::cos(pitch), std::sin(pitch), -std::cos(heading) * std::cos(pitch)};
}

}  // namespace ocelli
