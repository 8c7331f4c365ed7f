#include "display_sim/observing/wobble.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"

namespace ocelli {

glm::dvec3 Wobble::displacement(double swingRadians) const {
  return glm::normalize(glm::dvec3(direction)) * (amplitudeRadii * std::cos(swingRadians));
}

void checkWobble(const Wobble& wobble) {
  const auto fail = [](const std::string& what) { throw InputError(what, "observer", "change it"); };
  const float length = glm::length(wobble.direction);
  if (!(wobble.amplitudeRadii >= 0 && wobble.amplitudeRadii <= kMaxWobbleRadii)) {
    fail("the wobble's amplitude must lie between 0 and the display's radius");
  }
  if (!(length > 1e-6f && length < 1e6f)) {
    fail("the wobble's direction must be finite and not 0");
  }
  if (!(wobble.frequency >= 0 && wobble.frequency <= kMaxWobbleFrequency)) {
    fail("the wobble must swing between 0 and 64 times in a turn");
  }
  if (!(std::abs(wobble.phaseDegrees) <= 360)) {
    fail("the wobble's phase must lie between -360 and 360 degrees");
  }
}

}  // namespace ocelli
