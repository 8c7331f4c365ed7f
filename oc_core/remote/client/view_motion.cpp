#include "oc_core/remote/client/view_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

namespace ocelli {
namespace {

constexpr double kResting = 1e-6;  ///< units, radians or e-foldings a second
constexpr double kMaxZoomAhead = 2;
constexpr double kMinFov = 0.1;
constexpr double kMaxFov = 170;

double zoomOf(const View& view) {
  return -std::log(std::tan(radiansFromDegrees(view.resolvedFovVerticalDegrees()) / 2));
}

/// Columns: right, up and backward.
glm::dmat3 axesOf(const View& view) {
  const glm::dvec3 backward = glm::normalize(glm::dvec3(view.eye) - glm::dvec3(view.target));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(view.up), backward));
  return {right, glm::cross(backward, right), backward};
}

}  // namespace

bool ViewMotion::isResting() const {
  return glm::length(eyePerSecond) < kResting && glm::length(turnPerSecond) < kResting &&
         std::abs(zoomPerSecond) < kResting;
}

ViewMotion motionBetween(const View& before, const View& after, double seconds) {
  ViewMotion motion;
  if (!(seconds > 0)) {
    return motion;
  }
  motion.eyePerSecond = (glm::dvec3(after.eye) - glm::dvec3(before.eye)) / seconds;
  glm::dquat turn = glm::quat_cast(axesOf(after) * glm::transpose(axesOf(before)));
  if (turn.w < 0) {
    turn = -turn;
  }
  const glm::dvec3 sine(turn.x, turn.y, turn.z);
  const double length = glm::length(sine);
  if (length > 0) {
    motion.turnPerSecond = sine / length * (2 * std::atan2(length, turn.w) / seconds);
  }
  motion.zoomPerSecond = (zoomOf(after) - zoomOf(before)) / seconds;
  return motion;
}

View viewAhead(const View& view, const ViewMotion& motion, double seconds) {
  View ahead = view;
  ahead.eye = glm::vec3(glm::dvec3(view.eye) + motion.eyePerSecond * seconds);
  glm::dvec3 forward = glm::dvec3(view.target) - glm::dvec3(view.eye);
  glm::dvec3 up(view.up);
  const double fov = view.resolvedFovVerticalDegrees();
  const double rate = glm::length(motion.turnPerSecond);
  if (rate > 0) {
    const double angle = std::min(rate * seconds, radiansFromDegrees(fov) / 2);
    const glm::dquat turn = glm::angleAxis(angle, motion.turnPerSecond / rate);
    forward = turn * forward;
    up = turn * up;
  }
  ahead.target = glm::vec3(glm::dvec3(ahead.eye) + forward);
  ahead.up = glm::vec3(up);
  const double bound = std::log(kMaxZoomAhead);
  const double zoom = zoomOf(view) + std::clamp(motion.zoomPerSecond * seconds, -bound, bound);
  ahead.fovVerticalDegrees = std::clamp(degreesFromRadians(2 * std::atan(std::exp(-zoom))), kMinFov, kMaxFov);
  return ahead;
}

}  // namespace ocelli
