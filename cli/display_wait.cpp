#include "cli/display_wait.h"

#include <fmt/format.h>

#include <thread>

namespace ocelli {
namespace {

using namespace std::chrono_literals;

/// A device that looks for its display on a thread of its own has found one by then.
constexpr double kGraceSeconds = 0.3;
constexpr double kTellEverySeconds = 10;
constexpr auto kLookEvery = 20ms;

}  // namespace

DisplayWait::DisplayWait(Device& device, const CommandContext& context)
    : device_(device), context_(context), progress_(context.progress()) {}

double DisplayWait::secondsMissing() const {
  return missingSince_ ? std::chrono::duration<double>(Clock::now() - *missingSince_).count() : 0;
}

bool DisplayWait::look() {
  const Telemetry telemetry = device_.telemetry();
  if (telemetry.connected) {
    if (told_) {
      context_.note(fmt::format("the display is there, after {:.1f} s", secondsMissing()));
    }
    missingSince_.reset();
    told_ = false;
    return true;
  }
  if (!missingSince_) {
    missingSince_ = Clock::now();
    nextTold_ = kGraceSeconds;
  }
  const double missing = secondsMissing();
  if (missing < kGraceSeconds) {
    return false;
  }
  if (!told_) {
    const std::string why = telemetry.lastProblem.empty() ? "nothing answers" : telemetry.lastProblem;
    context_.note(fmt::format("the display is not there: {}\n  waiting for it; Ctrl-C ends this", why));
    told_ = true;
    nextTold_ = kTellEverySeconds;
  } else if (!progress_ && missing >= nextTold_) {
    context_.note(fmt::format("waiting for the display for {:.0f} s", missing));
    nextTold_ += kTellEverySeconds;
  }
  report(progress_, fmt::format("waiting for the display, {:.0f} s", missing), 0);
  return false;
}

bool DisplayWait::untilThere(std::optional<double> seconds, const std::function<bool()>& stop) {
  const Clock::time_point begin = Clock::now();
  while (!look()) {
    if (stop() || (seconds && std::chrono::duration<double>(Clock::now() - begin).count() >= *seconds)) {
      return false;
    }
    std::this_thread::sleep_for(kLookEvery);
  }
  return true;
}

}  // namespace ocelli
