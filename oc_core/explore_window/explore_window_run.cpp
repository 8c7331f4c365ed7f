#include "oc_core/explore_window/explore_window_run.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/free_file_name.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/explore_window/explore_window.h"
#include "oc_core/window/gamepads.h"
#include "oc_core/window/gl_window.h"

namespace ocelli {
namespace {

/// Where nothing moves, gamepads are looked at so often.
constexpr double kExploreRest = 0.05;
/// ... and while someone walks. New pictures end the wait.
constexpr double kExploreWait = 1.0 / 60;

using RunClock = std::chrono::steady_clock;

class ExploreRun {
 public:
  explicit ExploreRun(const ExploreWindowRunOptions& options)
      : options_(options),
        recorder_(options.record),
        window_({.title = options.title, .width = 1280, .height = 720}),
        explore_(window_.context(), {.make = makeExplorerModel(options.model),
                                     .way = ExploreWindowWork::Way::kThread,
                                     .folder = options.folder,
                                     .woken = [] { GlWindow::wake(); }}) {}

  void run() {
    auto last = RunClock::now();
    while (!explore_.wantsClose() && (!options_.goesOn || options_.goesOn())) {
      takeEvents();
      const auto now = RunClock::now();
      const double seconds = std::chrono::duration<double>(now - last).count();
      last = now;
      explore_.update(seconds);
      followState();
      if (explore_.needsDrawing()) {
        explore_.draw();
        const GlScope scope(window_.context());
        window_.show(explore_.target().framebuffer(), explore_.target().width(), explore_.target().height());
      }
      record(seconds);
    }
    if (recorder_.isOn()) {
      try {
        stopRecording();
      } catch (...) {
        freeName();
        throw;
      }
    }
  }

 private:
  void takeEvents() {
    for (const TimedWindowEvent& timed : window_.pollTimed(explore_.isLively() ? kExploreWait : kExploreRest)) {
      if (const auto* input = std::get_if<InputEvent>(&timed.event)) {
        explore_.handle(*input);
      } else if (const auto* focus = std::get_if<FocusEvent>(&timed.event)) {
        hasFocus_ = focus->focused;
        if (!hasFocus_) {
          explore_.loseFocus();
        }
      }
    }
    explore_.handleGamepad(hasFocus_ ? readFirstGamepad() : std::nullopt);
  }

  void followState() {
    if (explore_.state().captured != isCaptured_) {
      isCaptured_ = explore_.state().captured;
      window_.setCursor(isCaptured_ ? CursorMode::kCaptured : CursorMode::kShown);
    }
    if (explore_.takeFullscreenWish()) {
      window_.setFullscreen(!window_.isFullscreen());
    }
    if (options_.video && !hasBegun_ && explore_.picture() != nullptr) {
      hasBegun_ = true;
      try {
        startRecording(*options_.video);
      } catch (const Error& error) {
        sayRecordingFailed(error);
      }
    }
    if (explore_.takeRecordWish()) {
      try {
        if (recorder_.isOn()) {
          stopRecording();
        } else {
          madeFile_ = makeFreeFile(options_.folder, "explore", ".mp4");
          startRecording(*madeFile_);
        }
      } catch (const Error& error) {
        sayRecordingFailed(error);
      }
    }
  }

  void startRecording(const std::filesystem::path& path) {
    recorder_.start(path, explore_.target().width(), explore_.target().height());
    explore_.state().recording = true;
  }
  void stopRecording() {
    explore_.state().recording = false;
    recorder_.stop();
    madeFile_.reset();
    explore_.say("saved " + recorder_.path().string(), false);
    if (options_.wrote) {
      options_.wrote(recorder_.path());
    }
  }

  void record(double seconds) {
    if (!recorder_.isOn()) {
      return;
    }
    sinceRecorded_ += seconds;
    if (recorder_.isDue(sinceRecorded_)) {
      try {
        recorder_.add(explore_.screenshot(), std::exchange(sinceRecorded_, 0));
      } catch (const Error& error) {
        sayRecordingFailed(error);
      }
    }
  }

  /// One walks on.
  void sayRecordingFailed(const Error& error) {
    explore_.state().recording = recorder_.isOn();
    freeName();
    explore_.say(error.what(), true);
  }

  /// The name that the video was to have is free again.
  void freeName() {
    if (madeFile_) {
      std::error_code ignored;
      std::filesystem::remove(*madeFile_, ignored);
      madeFile_.reset();
    }
  }

  const ExploreWindowRunOptions& options_;
  ExploreRecorder recorder_;
  GlWindow window_;
  ExploreWindow explore_;
  bool hasFocus_ = true;
  bool isCaptured_ = false;
  bool hasBegun_ = false;
  std::optional<std::filesystem::path> madeFile_;  ///< empty, of the video that is recorded, but for that of --record
  double sinceRecorded_ = 0;
};

}  // namespace

void runExploreWindow(const ExploreWindowRunOptions& options) {
  makeFolder(options.folder);
  ExploreRun(options).run();
}

}  // namespace ocelli
