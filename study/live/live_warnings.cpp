#include "study/live/live_warnings.h"

#include <algorithm>
#include <array>

namespace ocelli {
namespace {

struct WarningRow {
  std::string_view event;
  std::string_view text;
};

constexpr std::array kWarnings{
    WarningRow{"late_frames", "Frames of a trial came late."},
    WarningRow{"early_frames", "Frames of a trial came too early: they did not wait for the screen."},
    WarningRow{"focus_lost", "The window lost the keyboard."},
    WarningRow{"monitor_lost", "The monitor was disconnected."},
    WarningRow{"clock_jump", "The clock of this computer was set. Trials are not affected."},
    WarningRow{"screen_changed", "The subject has another screen than in the first trial."},
    WarningRow{"screen_deviates", "The screen differs from what the protocol states."},
    WarningRow{"practice_failed", "Practice did not succeed."},
    WarningRow{"unwell", "The subject asked to stop (F10)."},
    WarningRow{"record_refused", "A record could not be stored."},
    WarningRow{"gaze_lost", "Samples of gaze were lost."},
    WarningRow{"responses_lost", "A response device was disconnected."},
};

}  // namespace

std::string_view warningOf(std::string_view event) {
  const auto* const row = std::ranges::find(kWarnings, event, &WarningRow::event);
  return row == kWarnings.end() ? std::string_view() : row->text;
}

}  // namespace ocelli
