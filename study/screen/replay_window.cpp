#include "study/screen/replay_window.h"

#include <algorithm>
#include <chrono>

#include "oc_core/window/gl_window.h"
#include "study/replay/gaze_trail.h"
#include "study/screen/study_painter.h"

namespace ocelli {
namespace {

constexpr int kMaxWidth = 1600;
/// Where drawing cannot keep up, frames are left out, but not for longer than that, seconds.
constexpr double kLongestGap = 0.1;

using Clock = std::chrono::steady_clock;

struct Closed {};

/// Throws Closed where the person wants no more.
void requireOpen(GlWindow& window, double waitSeconds) {
  for (const InputEvent& event : window.poll(waitSeconds)) {
    const auto* key = std::get_if<KeyEvent>(&event);
    if (std::holds_alternative<CloseEvent>(event) || (key != nullptr && key->pressed && key->key == Key::kEscape)) {
      throw Closed();
    }
  }
}

}  // namespace

bool showReplay(const TaskBlock& block, const TrialLog& log, const Controls& controls,
                const ReplayWindowOptions& options) {
  const TrialScreen& screen = log.record.screen;
  const int width = std::min(screen.width, kMaxWidth);
  GlWindow window({.title = options.title, .width = width, .height = width * screen.height / screen.width});
  const GlScope scope(window.context());
  StudyPainter painter(window.context(), screen, controls);
  const Clock::time_point began = Clock::now();
  double drawnAt = -1;
  ReplayOptions replay;
  replay.onFrame = [&](const FrameRecord& frame, const TrialRun& run) {
    const double at =
        static_cast<double>(frame.shownNanoseconds - log.frames.front().shownNanoseconds) * 1e-9 / options.speed;
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
    while (elapsed() < at) {
      requireOpen(window, at - elapsed());
    }
    if (at < elapsed() - kLongestGap / 2 && elapsed() < drawnAt + kLongestGap) {
      return;
    }
    drawnAt = elapsed();
    requireOpen(window, 0);
    painter.draw(TrialScreenView{run.layout(), false, false, gazeTrail(log.gaze, frame.shownNanoseconds)});
    window.show(painter.framebuffer(), screen.width, screen.height);
  };
  try {
    replayTrial(block, log, replay);
    return true;
  } catch (const Closed&) {
    return false;
  }
}

}  // namespace ocelli
