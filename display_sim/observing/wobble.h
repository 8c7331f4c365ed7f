// The wobble of a display that is not perfectly balanced: its axis, with the screen on it, swings along a line.
// Dissertation section 3.5.5.6 estimates the amplitude of the reference display at 0.5 cm.
//
// At the screen angle t, counted on over all turns, the axis is moved by
//   amplitude direction cos(frequency t + phase).
// A rotor out of balance gives the frequency 1: after half a turn, when a mirrored volume is shown again, the axis
// stands on the other side, and what is seen twice is seen double. A whole turn later it stands where it was.
#pragma once

#include <glm/vec3.hpp>

namespace ocelli {

struct Wobble {
  double amplitudeRadii = 0;     ///< 0: none
  glm::vec3 direction{1, 0, 0};  ///< of any length but 0
  double frequency = 1;          ///< swings in a turn of the screen
  double phaseDegrees = 0;       ///< of a swing, at the screen angle 0

  /// Where the axis is moved to at this phase of a swing, in display radii.
  glm::dvec3 displacement(double swingRadians) const;
};

inline constexpr double kMaxWobbleRadii = 1;
inline constexpr double kMaxWobbleFrequency = 64;

/// Throws InputError, naming the observer, for values that make no sense.
void checkWobble(const Wobble& wobble);

}  // namespace ocelli
