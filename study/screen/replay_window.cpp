#include "study/screen/replay_window.h"

#include <algorithm>
#include <chrono>

#include "oc_core/gl/gl_window.h"
#include "study/screen/study_painter.h"

namespace ocelli {
namespace {

constexpr int kMostWidth = 1600;

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
  const int width = std::min(screen.width, kMostWidth);
  GlWindow window({.title = options.title, .width = width, .height = width * screen.height / screen.width});
  const GlScope scope(window.context());
  StudyPainter painter(window.context(), screen, controls);
  const Clock::time_point began = Clock::now();
  ReplayOptions replay;
  replay.onFrame = [&](const FrameRecord& frame, const TrialRun& run) {
    const double at =
        static_cast<double>(frame.shownNanoseconds - log.frames.front().shownNanoseconds) * 1e-9 / options.speed;
    for (;;) {
      const double left = at - std::chrono::duration<double>(Clock::now() - began).count();
      requireOpen(window, std::max(left, 0.0));
      if (left <= 0) {
        break;
      }
    }
    painter.draw(TrialScreenView{run.picture()});
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
