// Where level rays lie in the images of maze cameras. In the middle of a wide image they would leave the floor out: in
// a corridor, as wide as the image where the user stands, it would begin only behind the crossing. So they lie higher,
// and the image holds the floor to its lower edge, or as near to it as its shape allows.
#pragma once

#include <algorithm>

namespace ocelli {

/// Of the image's height, from the top to level rays: above them lies what is higher than the eye, which says less.
inline constexpr double kHorizonShare = 0.3;
/// Of the height of the eye: rays begin this little above the floor, not in it.
inline constexpr double kAboveFloor = 0.99;

/// From the middle of the image to level rays, downwards, in image heights (View::centerShift). Where rays begin, the
/// image is `windowHeight` tall, 0 for those of a pinhole; the eye is `eyeHeight` over the floor there, and nothing
/// below the floor is shown.
inline double horizonShift(double eyeHeight, double windowHeight) {
  const double above = windowHeight > 0 ? 1 - kAboveFloor * std::max(eyeHeight, 0.0) / windowHeight : 0;
  return std::clamp(above, kHorizonShare, 1.0) - 0.5;
}

}  // namespace ocelli
