#include "display_sim/viewer/view_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

namespace ocelli {
namespace {

constexpr double kMinAngleToPole = 0.03;  // radians

View withFieldOfView(const View& view) {
  View moved = view;
  moved.fovVerticalDegrees = view.resolvedFovVerticalDegrees();
  return moved;
}

}  // namespace

View orbited(const View& view, double right, double up) {
  const glm::dvec3 target(view.target);
  const glm::dvec3 pole = glm::normalize(glm::dvec3(view.up));
  glm::dvec3 arm = glm::dvec3(view.eye) - target;
  const double distance = glm::length(arm);
  const double angle = std::acos(std::clamp(glm::dot(arm / distance, pole), -1.0, 1.0));
  const double wanted = std::clamp(angle - up, kMinAngleToPole, kPi - kMinAngleToPole);
  const glm::dvec3 level = glm::normalize(glm::cross(pole, arm));
  arm = glm::dvec3(glm::rotate(glm::dmat4(1), wanted - angle, level) * glm::dvec4(arm, 0));
  arm = glm::dvec3(glm::rotate(glm::dmat4(1), right, pole) * glm::dvec4(arm, 0));
  View moved = withFieldOfView(view);
  moved.eye = glm::vec3(target + arm);
  return moved;
}

View panned(const View& view, double right, double up) {
  const glm::dvec3 arm = glm::dvec3(view.eye) - glm::dvec3(view.target);
  const glm::dvec3 backward = glm::normalize(arm);
  const glm::dvec3 rightward = glm::normalize(glm::cross(glm::dvec3(view.up), backward));
  const glm::dvec3 upward = glm::cross(backward, rightward);
  View moved = withFieldOfView(view);
  const double imageHeight = 2 * glm::length(arm) * std::tan(radiansFromDegrees(moved.fovVerticalDegrees) / 2);
  const glm::vec3 step(imageHeight * (right * rightward + up * upward));
  if (glm::length(moved.target + step) > kFarthestTarget) {
    return moved;
  }
  moved.eye += step;
  moved.target += step;
  return moved;
}

View zoomed(const View& view, double factor) {
  View moved = withFieldOfView(view);
  const glm::dvec3 arm = glm::dvec3(view.eye) - glm::dvec3(view.target);
  const double distance = glm::length(arm);
  const double wanted = std::clamp<double>(distance * factor, kMinViewDistance, kMaxViewDistance);
  moved.eye = glm::vec3(glm::dvec3(view.target) + arm * (wanted / distance));
  return moved;
}

}  // namespace ocelli
