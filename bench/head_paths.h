// Ways of heads, made up: nobody was recorded. A head leans from one place to the next along minimum-jerk curves (T.
// Flash and N. Hogan, The coordination of arm movements, 1985), rests there, and sways all the while.
#pragma once

#include <cstdint>
#include <vector>

#include "display_sim/observing/eye_path.h"

namespace ocelli {

/// From a seed, for so long; no tracker's noise. Places lie within a display radius of (0, 0.4, 10).
std::vector<EyePose> madeUpHeadPath(uint64_t seed, double seconds, double posesPerSecond);

/// The same as a tracker tells it that is off by `deviation` display radii along each axis (normally distributed).
std::vector<EyePose> withTrackerNoise(std::vector<EyePose> path, uint64_t seed, double deviation);

}  // namespace ocelli
