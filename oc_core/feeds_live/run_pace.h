// The pace of a run that people watch: recorded feeds go on no faster than they were taken.
#pragma once

#include <chrono>
#include <optional>

namespace ocelli {

class RunPace {
 public:
  using Clock = std::chrono::steady_clock;

  /// When the image of `seconds`, in the time of the place, is to be shown: as long after the one before as they are
  /// apart, or at once where that is over. What was lost is not caught up with, so that a run goes on at its pace after
  /// a pause.
  Clock::time_point due(double seconds, Clock::time_point now);

 private:
  std::optional<double> lastSeconds_;
  Clock::time_point lastDue_;
};

}  // namespace ocelli
