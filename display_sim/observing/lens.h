// The lens of an eye or a camera that is focused at one distance: a point nearer or farther becomes a disc.
#pragma once

#include <cmath>

namespace ocelli {

struct Lens {
  double apertureRadii = 0;  ///< diameter of the pupil, in display radii; 0: a pinhole, everything is sharp
  double focusRadii = 0;     ///< distance along the view direction that is sharp; 0: the display's centre
};

/// Diameter in pixels of the disc (circle of confusion) that a thin lens makes of a point at distance `z`, where
/// `focus` is sharp and one unit at distance 1 has `pixelsPerTangent` pixels. Rays from the point fill the pupil; where
/// they cross the plane in focus they are aperture |focus - z| / z apart, which the image shows at pixelsPerTangent /
/// focus.
inline double circleOfConfusion(double aperture, double focus, double z, double pixelsPerTangent) {
  return pixelsPerTangent * aperture * std::abs(1 / z - 1 / focus);
}

}  // namespace ocelli
