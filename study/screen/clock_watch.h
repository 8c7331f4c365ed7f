// Notices when the clock of the system is set: by the experimenter, by the network, by a change of the battery.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

namespace ocelli {

class ClockWatch {
 public:
  static constexpr int64_t kMinJump = 1'000'000'000;  ///< nanoseconds

  /// Times of the clock of the system and of one that never jumps. Returns by how much the former was set forward (or
  /// back, negative) since the last time, in nanoseconds, where that is a second or more. Slow drifts are no jumps.
  std::optional<int64_t> look(int64_t systemNanoseconds, int64_t steadyNanoseconds) {
    const int64_t ahead = systemNanoseconds - steadyNanoseconds;
    if (!ahead_) {
      ahead_ = ahead;
    }
    const int64_t jump = ahead - *ahead_;
    ahead_ = ahead;
    return std::abs(jump) >= kMinJump ? std::optional(jump) : std::nullopt;
  }

 private:
  std::optional<int64_t> ahead_;
};

}  // namespace ocelli
