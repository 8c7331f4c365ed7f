// Where a subject looked at a moment of a replay, and shortly before: a ring with a trail, white with a dark edge,
// which stands out from every scene, for colour-blind people too.
#pragma once

#include <span>
#include <vector>

#include "oc_core/image/png_file.h"
#include "study/session/records.h"
#include "study/session/session_screen.h"

namespace ocelli {

inline constexpr double kTrailSeconds = 0.3;
inline constexpr double kGazeRadius = 14;  ///< of the ring, in units of gazeUnit()
/// Pixels; 1 on a screen that is 1280 wide.
constexpr double gazeUnit(int screenWidth) {
  return screenWidth > 1280 ? screenWidth / 1280.0 : 1.0;
}

/// Of samples in the order in which they came: the valid ones of the last kTrailSeconds before that time. Empty where
/// the newest sample is not valid: the eye was closed.
std::vector<GazeMark> gazeTrail(std::span<const GazeRecord> samples, int64_t nanoseconds);

/// Over an image of the whole screen.
void drawGaze(Image<Rgb8>& image, std::span<const GazeMark> marks);

}  // namespace ocelli
