// Tells people that a display is not there, while it is waited for.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "cli/command.h"
#include "display_driver/device/device.h"

namespace ocelli {

class DisplayWait {
 public:
  /// Both outlive it.
  DisplayWait(Device& device, const CommandContext& context);

  /// Whether the display is there, and if not, what is missing. Call it some times a second: a note comes once for
  /// each loss and each return, and from time to time how long it has been missing, where no bar shows that.
  bool look();
  /// Returns whether the display came before `seconds` were over and `stop` was true.
  bool untilThere(std::optional<double> seconds, const std::function<bool()>& stop);

 private:
  using Clock = std::chrono::steady_clock;
  double secondsMissing() const;

  Device& device_;
  const CommandContext& context_;
  Progress progress_;
  std::optional<Clock::time_point> missingSince_;
  bool told_ = false;
  double nextTold_ = 0;
};

}  // namespace ocelli
