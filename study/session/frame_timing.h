// Verdict on when the frames of a trial were shown.
#pragma once

#include <span>

#include "study/protocol/protocol.h"
#include "study/session/records.h"

namespace ocelli {

struct FrameClock {
  int64_t intervalNanoseconds = 16'666'667;  ///< of the screen
  bool unstable = false;                     ///< by the check at the start
  bool simulated = false;
};

/// Of frames that were shown at these times, in order.
TrialTiming timingOf(std::span<const int64_t> shownNanoseconds, const TimingLimits& limits, const FrameClock& clock);

}  // namespace ocelli
