#include "oc_core/feeds/subject_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ocelli {
namespace {

constexpr double kWalkSpeed = 1.2;     ///< metres a second: of a velocity that is not known
constexpr double kAcceleration = 2.5;  ///< metres a second squared: people turn within half a second
constexpr double kMaxWalkSpeed = 3;    ///< metres a second
constexpr double kMaxDeviations = 3;   ///< what is told farther off counts for less

}  // namespace

SubjectMotion::SubjectMotion(const glm::dvec2& place, double error) : state_(place, 0, 0), covariance_(0) {
  covariance_[0][0] = covariance_[1][1] = error * error;
  covariance_[2][2] = covariance_[3][3] = kWalkSpeed * kWalkSpeed;
}

void SubjectMotion::goOn(double seconds) {
  if (seconds <= 0) {
    return;
  }
  glm::dmat4 step(1);
  step[2][0] = step[3][1] = seconds;  // columns first
  state_ = step * state_;
  covariance_ = step * covariance_ * glm::transpose(step);
  // An acceleration that is random anew at each step, so that its effect does not depend on how long steps are.
  const double power = kAcceleration * kAcceleration / 3;
  const double places = power * seconds * seconds * seconds / 3;
  const double both = power * seconds * seconds / 2;
  for (int i = 0; i < 2; ++i) {
    covariance_[i][i] += places;
    covariance_[i][i + 2] += both;
    covariance_[i + 2][i] += both;
    covariance_[i + 2][i + 2] += power * seconds;
  }
}

void SubjectMotion::tell(const glm::dvec2& axis, double coordinate, double deviation) {
  const glm::dvec4 along(axis, 0, 0);
  const glm::dvec4 spread = covariance_ * along;
  const double expected = glm::dot(along, state_);
  const double known = glm::dot(along, spread);
  double variance = known + deviation * deviation;
  const double away = coordinate - expected;
  variance *= std::max(1.0, away * away / (kMaxDeviations * kMaxDeviations * variance));
  const glm::dvec4 gain = spread / variance;
  state_ += gain * away;
  covariance_ -= glm::outerProduct(gain, spread);
  if (const double speed = glm::length(velocity()); speed > kMaxWalkSpeed) {
    state_.z *= kMaxWalkSpeed / speed;
    state_.w *= kMaxWalkSpeed / speed;
  }
}

double SubjectMotion::deviationAlong(const glm::dvec2& axis) const {
  const glm::dvec4 along(axis, 0, 0);
  return std::sqrt(std::max(0.0, glm::dot(along, covariance_ * along)));
}

}  // namespace ocelli
