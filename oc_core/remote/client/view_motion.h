// How a view moves, and where it will be: what a client asks ahead by. Smooth navigation changes each parameter of a
// view continuously (section 5.3.1.4), so it goes on for a while as it went.
#pragma once

#include <glm/vec3.hpp>

#include "oc_core/camera/view.h"

namespace ocelli {

struct ViewMotion {
  glm::dvec3 eyePerSecond{0};
  glm::dvec3 turnPerSecond{0};  ///< a rotation vector of the world: its length is the angle, radians
  double zoomPerSecond = 0;     ///< of ln(1 / tan(half the field of view)): positive where the view zooms in

  bool isResting() const;
};

/// From one view to another that is `seconds` later; at rest where `seconds` is not positive.
ViewMotion motionBetween(const View& before, const View& after, double seconds);

/// Where the view will be, with a field of view that is given in degrees. Never turned by more than half of its
/// vertical field of view, and never zoomed by more than a factor of 2: what moves fast rarely goes on for long. Its
/// fields of view stay between 0.1 and 170 degrees.
View viewAhead(const View& view, const ViewMotion& motion, double seconds);

}  // namespace ocelli
