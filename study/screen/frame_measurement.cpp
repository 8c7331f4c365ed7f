#include "study/screen/frame_measurement.h"

#include <fmt/format.h>

#include <chrono>
#include <set>

#include "study/screen/protocol_texts.h"
#include "study/screen/study_painter.h"
#include "study/session/frame_timing.h"

namespace ocelli {
namespace {

constexpr int kSettlingFrames = 15;  // until the driver's queue has its length
constexpr int kSettlingTrialFrames = 3;
constexpr double kTrialSeconds = 0.5;
constexpr int kMinTrialFrames = 12;

/// Frames that `draw` draws, for so many seconds after so many that do not count.
template <class Draw>
std::vector<int64_t> showFrames(GlWindow& window, StudyPainter& painter, int settling, double seconds, int minFrames,
                                const Draw& draw) {
  std::vector<int64_t> shown;
  int frames = 0;
  for (int64_t start = steadyNow();
       static_cast<double>(steadyNow() - start) < seconds * 1e9 || frames < settling + minFrames;) {
    window.pollTimed(0);
    draw(frames);
    window.present(painter.framebuffer(), window.pixelWidth(), window.pixelHeight());
    window.awaitFrame();
    if (++frames == settling) {
      start = steadyNow();
    }
    if (frames > settling) {
      shown.push_back(steadyNow());
    }
  }
  return shown;
}

}  // namespace

int64_t steadyNow() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<int64_t> measureFrames(GlWindow& window, double seconds, const SubjectTexts& texts) {
  const GlScope scope(window.context());
  StudyPainter painter(window.context(), {window.pixelWidth(), window.pixelHeight(), 60}, {}, {}, texts);
  PageScreen page;
  page.title = texts.say("one_moment");
  return showFrames(window, painter, kSettlingFrames, seconds, 2, [&](int frame) {
    if (frame == 0) {
      painter.draw(page);
    }
  });
}

std::vector<MeasuredTrial> measureTrials(GlWindow& window, const Protocol& protocol, const SessionSchedule& schedule,
                                         const TrialScreen& screen, int64_t intervalNanoseconds) {
  const GlScope scope(window.context());
  StudyPainter painter(window.context(), screen, protocol.controls, glyphsOf(protocol), protocol.texts);
  std::vector<MeasuredTrial> all;
  std::set<std::pair<int, TrialView>> measured;
  for (const TrialPlan& plan : schedule.trials) {
    if (!measured.insert({plan.block, plan.view}).second) {
      continue;
    }
    const ProtocolBlock& block = protocol.blocks[static_cast<size_t>(plan.block)];
    const std::unique_ptr<TrialRun> run = block.task->start(plan, screen);
    const int64_t began = steadyNow();
    const std::vector<int64_t> shown =
        showFrames(window, painter, kSettlingTrialFrames, kTrialSeconds, kMinTrialFrames, [&](int /*frame*/) {
          TrialScreenView view;
          view.layout = run->layout();
          view.layout.tick = ticksBetween(began, steadyNow());
          painter.draw(view);
        });
    all.push_back({block.name, protocol.nameOf(plan.view),
                   timingOf(shown, protocol.timing, {.intervalNanoseconds = intervalNanoseconds})});
  }
  return all;
}

std::vector<std::string> slowTrials(const std::vector<MeasuredTrial>& measured) {
  std::vector<std::string> problems;
  for (const MeasuredTrial& each : measured) {
    if (each.timing.verdict == TimingVerdict::kDroppedFrames) {
      problems.push_back(fmt::format(
          "trials of the block \"{}\" in the condition \"{}\" are too slow for this screen: {} of {} frames came late, "
          "the median after {:.0f} ms",
          each.block, each.condition, each.timing.dropped, each.timing.frames,
          static_cast<double>(each.timing.medianNanoseconds) / 1e6));
    }
  }
  return problems;
}

}  // namespace ocelli
