// Which volume of a time series is shown when.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "display_driver/pacing/motion_clock.h"

namespace ocelli {

/// The volume that is shown `seconds` after the series began to be played, of those that begin at `times`: seconds of
/// the series, rising. The last one stays as long as one does in the mean. Nothing where the series has ended; the
/// first one of a series with fewer than two times, which never ends.
std::optional<size_t> seriesMoment(std::span<const double> times, double seconds, const MotionPlayback& playback);

}  // namespace ocelli
