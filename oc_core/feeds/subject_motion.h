// Where a subject is and how it walks, from what feeds tell of it: a Kalman filter in the plan (x, z) of places and
// velocities that stay the same but for small random accelerations.
//
// A feed tells much of a place across its line of sight and little along it, so what it tells is taken apart into
// coordinates along axes of the plan: where two feeds see somebody from different sides, the filter triangulates
// (section 4.3.3).
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace ocelli {

class SubjectMotion {
 public:
  /// At a place, told with an error in metres; nothing is known of the velocity but that people walk.
  SubjectMotion(const glm::dvec2& place, double error);

  /// Goes on as it walked. `seconds` is at least 0.
  void goOn(double seconds);
  /// A coordinate of the place along a unit vector was told, with a standard deviation in metres. One that is very far
  /// from what is expected counts for less.
  void tell(const glm::dvec2& axis, double coordinate, double deviation);

  glm::dvec2 place() const { return {state_.x, state_.y}; }
  glm::dvec2 velocity() const { return {state_.z, state_.w}; }  ///< metres a second
  /// The standard deviation of the place along a unit vector, metres.
  double deviationAlong(const glm::dvec2& axis) const;

 private:
  glm::dvec4 state_;  ///< x, z of the place, then of the velocity
  glm::dmat4 covariance_;
};

}  // namespace ocelli
