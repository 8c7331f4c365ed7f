// Ambient light at points of surfaces (section 4.3.4.4): the share of the light of an even sky that reaches them.
//
//   light = 1 - 1/pi * integral over the hemisphere of  W(distance to the first hit) * cos(angle to the normal)
//
// W is 1 at the point and 0 from a radius on: what is farther away hides nothing.
#pragma once

#include <cstddef>

namespace ocelli {

struct AmbientOptions {
  double radius = 0.3;     ///< of what hides light, world units; 0: nothing hides any
  bool attenuates = true;  ///< W = 1 - (distance / radius)^2, after Bavoil et al.; else 1 within the radius

  /// W; the distance is not negative.
  double weight(double distance) const {
    if (!(distance < radius)) {
      return 0;
    }
    const double share = distance / radius;
    return attenuates ? 1 - share * share : 1;
  }
};

/// Throws InputError where the radius is negative or not finite.
void validate(const AmbientOptions& options);

}  // namespace ocelli
