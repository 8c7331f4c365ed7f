#include "oc_core/feeds_live/run_pace.h"

#include <algorithm>

namespace ocelli {
namespace {

/// So much is caught up with: an image that takes longer than others leaves no gap.
constexpr std::chrono::milliseconds kCaughtUp{100};

}  // namespace

RunPace::Clock::time_point RunPace::due(double seconds, Clock::time_point now) {
  lastDue_ = lastSeconds_ ? std::max(lastDue_ + std::chrono::duration_cast<Clock::duration>(
                                                    std::chrono::duration<double>(seconds - *lastSeconds_)),
                                     now - kCaughtUp)
                          : now;
  lastSeconds_ = seconds;
  return lastDue_;
}

}  // namespace ocelli
