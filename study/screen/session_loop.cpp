#include "study/screen/session_loop.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "oc_core/image/png_file.h"
#include "oc_core/window/screen_target.h"
#include "study/screen/clock_watch.h"
#include "study/screen/frame_measurement.h"
#include "study/screen/protocol_texts.h"
#include "study/screen/study_painter.h"
#include "study/screen/window_input.h"

namespace ocelli {
namespace {

constexpr double kPollSeconds = 0.1;
constexpr double kDevicePollSeconds = 0.002;  ///< where a device tells of nothing by itself
constexpr int64_t kNanosecondsPerSecond = 1'000'000'000;

int64_t systemNow() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

/// What the main thread and the one that draws tell each other.
struct Exchange {
  std::mutex mutex;
  std::vector<TimedWindowEvent> events;  ///< guarded
  std::atomic<CursorMode> cursor{CursorMode::kShown};
  std::atomic<bool> interrupted{false};
  std::atomic<bool> over{false};

  std::vector<TimedWindowEvent> take() {
    const std::scoped_lock lock(mutex);
    return std::exchange(events, {});
  }
};

/// Holds frames back where the screen does not.
class Pace {
 public:
  explicit Pace(double hertz) : interval_(hertz > 0 ? static_cast<int64_t>(1e9 / hertz) : 0) {}

  void wait() {
    if (interval_ == 0) {
      return;
    }
    const int64_t now = steadyNow();
    // Late frames shift all that follow, as they do where the screen decides.
    due_ = due_ == 0 || now > due_ + interval_ ? now : due_;
    std::this_thread::sleep_for(std::chrono::nanoseconds(std::max<int64_t>(due_ - now, 0)));
    due_ += interval_;
  }

 private:
  int64_t interval_;
  int64_t due_ = 0;
};

class ScreenRenderer {
 public:
  ScreenRenderer(GlWindow& window, const Protocol& protocol, SessionFlow& flow, ExperimenterConsole& console,
                 const SessionLoopOptions& options, Exchange& exchange)
      : window_(window),
        protocol_(protocol),
        flow_(flow),
        console_(console),
        options_(options),
        exchange_(exchange),
        began_(steadyNow()),
        screen_{window.pixelWidth(), window.pixelHeight(), 60},
        pixelsPerUnit_(window.size().pixelsPerUnit),
        pace_(options.pacedHertz) {}

  /// On its own thread.
  void run() {
    const GlScope scope(window_.context());
    StudyPainter painter(window_.context(), screen_, protocol_.controls, glyphsOf(protocol_), protocol_.texts);
    int64_t last = runNow();
    while (!flow_.isOver() && !quits_) {
      takeEvents(painter);
      takeCommands(painter);
      watchClock();
      const int64_t now = runNow();
      flow_.update(now);
      const SessionScreen screen = flow_.screen();
      const StudyFrame frame =
          painter.draw(screen, static_cast<double>(now - last) / kNanosecondsPerSecond, wantsHash(screen));
      last = now;
      setCursor(cursorFor(screen));
      window_.present(painter.framebuffer(), screen_.width, screen_.height);
      if (options_.pacedHertz > 0) {
        pace_.wait();
      } else {
        window_.awaitFrame();
      }
      const int64_t shown = runNow();
      if (options_.frameShown) {
        options_.frameShown(shown);
      }
      flow_.frameShown(shown, frame.pixelHash);
      if (frame.action) {
        flow_.act(*frame.action, runNow());
      }
      if (frame.key) {
        press(*frame.key, runNow());
      }
      keepImage(screen, painter);
      showStatus(now);
    }
  }

 private:
  /// Records count from the start of the run.
  int64_t runNow() const { return steadyNow() - began_; }

  void takeEvents(StudyPainter& painter) {
    for (const TimedWindowEvent& timed : exchange_.take()) {
      if (const auto* focus = std::get_if<FocusEvent>(&timed.event)) {
        if (!focus->focused && hadFocus_) {
          flow_.report("focus_lost", "");
          flow_.pause(protocol_.texts.say("paused_keyboard"));
        }
        hadFocus_ = focus->focused;
      } else if (const auto* lost = std::get_if<MonitorLostEvent>(&timed.event)) {
        flow_.report("monitor_lost", lost->name);
        // Whatever shows the window now was not checked: neither its size nor its timing.
        flow_.abort(fmt::format("the monitor \"{}\" was disconnected", lost->name));
        quits_ = true;
        console_.print(
            fmt::format("the monitor \"{}\" is gone: connect it again, then: ocelli study resume", lost->name));
      } else {
        takeInput(painter, {std::get<InputEvent>(timed.event), timed.nanoseconds - began_});
      }
    }
    takeDevices(painter);
  }

  void takeKey(StudyPainter& painter, const KeyChange& change) {
    const KeyEvent event{change.key, change.pressed, change.modifiers};
    painter.handle(event);
    flow_.handle({event, change.nanoseconds - began_});
  }

  void takeDevices(StudyPainter& painter) {
    if (options_.responses != nullptr) {
      for (const KeyChange& change : options_.responses->take(steadyNow())) {
        takeKey(painter, change);
      }
      for (const std::string& device : options_.responses->lost()) {
        flow_.report("responses_lost", device);
        flow_.pause(protocol_.texts.say("paused_moment"));
        console_.print(
            fmt::format("{} is gone, and the session paused: connect it, quit, and go on with: ocelli study "
                        "resume; or answer with the keyboard: resume",
                        device));
      }
    }
    if (options_.gaze != nullptr) {
      std::vector<GazeRecord> samples = options_.gaze->take();
      for (GazeRecord& sample : samples) {
        sample.nanoseconds -= began_;
      }
      flow_.gaze(samples);
    }
  }

  void press(Key key, int64_t nanoseconds) {
    for (const bool pressed : {true, false}) {
      flow_.handle({KeyEvent{key, pressed, {}}, nanoseconds});
    }
  }

  void takeInput(StudyPainter& painter, const TimedInput& timed) {
    if (std::holds_alternative<CloseEvent>(timed.event)) {
      press(Key::kF10, timed.nanoseconds);  // as a subject who feels unwell would: the session asks
      return;
    }
    if (const auto* button = std::get_if<PointerButtonEvent>(&timed.event)) {
      turning_ = button->button == PointerButton::kRight ? button->pressed : turning_;
    }
    if (const auto* key = std::get_if<KeyEvent>(&timed.event); key != nullptr && options_.responses != nullptr) {
      for (const KeyChange& change :
           options_.responses->takeKey({key->key, key->pressed, timed.nanoseconds + began_, key->modifiers})) {
        takeKey(painter, change);
      }
      return;
    }
    const InputEvent event = inPixels(timed.event, pixelsPerUnit_);
    painter.handle(event);
    flow_.handle({event, timed.nanoseconds});
  }

  /// What the screen cannot show is not stored as if it had been shown.
  void pause(const std::string& reason, const StudyPainter& painter) {
    const std::string usual = protocol_.texts.say("paused_moment");
    const bool shown = painter.canShow(reason);
    flow_.pause(reason.empty() || !shown ? usual : reason);
    if (!shown) {
      console_.print("paused with \"" + usual + "\": the screen cannot show all characters of the reason; a note can");
    }
  }

  void takeCommands(const StudyPainter& painter) {
    if (exchange_.interrupted) {
      flow_.abort("interrupted");
      quits_ = true;
    }
    for (const ConsoleCommand& command : console_.take()) {
      switch (command.kind) {
        case ConsoleCommand::Kind::kPause:
          pause(command.text, painter);
          break;
        case ConsoleCommand::Kind::kResume:
          flow_.resume();
          break;
        case ConsoleCommand::Kind::kRedo:
          if (!flow_.redo()) {
            console_.print("there is no trial to do again: none was done, or the session has ended");
          }
          break;
        case ConsoleCommand::Kind::kAbort:
          flow_.abort(command.text);
          break;
        case ConsoleCommand::Kind::kNote:
          console_.print(flow_.note(command.text) ? "noted" : "not noted: nothing more of this session is stored");
          break;
        case ConsoleCommand::Kind::kStatus:
          console_.print(statusStep() + "  " + statusFigures());
          break;
        case ConsoleCommand::Kind::kQuit:
          flow_.abort("quit");
          quits_ = true;
          break;
        case ConsoleCommand::Kind::kHelp:
          break;
      }
    }
  }

  void watchClock() {
    if (const auto jump = clock_.look(systemNow(), steadyNow())) {
      const std::string seconds = fmt::format("{:+.3f} s", static_cast<double>(*jump) / 1e9);
      flow_.report("clock_jump", seconds);
      console_.print("the clock of this computer was set by " + seconds + "; trials are not affected");
    }
  }

  void setCursor(CursorMode mode) {
    if (exchange_.cursor.exchange(mode) != mode) {
      GlWindow::wake();
    }
  }

  bool wantsHash(const SessionScreen& screen) {
    if (!std::holds_alternative<TrialScreenView>(screen)) {
      trialFrames_ = 0;
      return false;
    }
    return options_.hashEvery > 0 && trialFrames_++ % options_.hashEvery == 0;
  }

  CursorMode cursorFor(const SessionScreen& screen) const {
    const auto* const trial = std::get_if<TrialScreenView>(&screen);
    if (trial == nullptr) {
      return CursorMode::kShown;
    }
    return turning_ ? CursorMode::kCaptured : CursorMode::kHidden;
  }

  void keepImage(const SessionScreen& screen, const StudyPainter& painter) {
    if (options_.screenshots.empty()) {
      return;
    }
    const std::string identity = identityOf(screen);
    if (identity != imaged_) {
      imaged_ = identity;
      const auto name = fmt::format("{:03}-{}.png", images_++, kindOf(screen));
      writePng(options_.screenshots / name, painter.image());
    }
  }

  std::string statusStep() const {
    const SessionStatus status = flow_.status();
    return fmt::format("{}: {}{}{}", options_.subject, status.step, status.paused ? " (paused)" : "",
                       status.wantsExperimenter ? " (calls you)" : "");
  }
  std::string statusFigures() const {
    const SessionStatus status = flow_.status();
    const TrialTiming& timing = status.lastTiming;
    const std::string last =
        timing.frames == 0
            ? ""
            : fmt::format(", last trial: {} frames, {} dropped, median {:.1f} ms, longest {:.1f} ms ({})",
                          timing.frames, timing.dropped, static_cast<double>(timing.medianNanoseconds) / 1e6,
                          static_cast<double>(timing.longestNanoseconds) / 1e6, nameOf(timing.verdict));
    return fmt::format("{} of {} trials done{}", status.progress.trialsDone, status.progress.trials, last);
  }
  /// Twice a second is as much as a person reads.
  void showStatus(int64_t now) {
    if (now - statusShown_ >= kNanosecondsPerSecond / 2) {
      statusShown_ = now;
      console_.setStatus(statusStep(), statusFigures());
    }
  }

  GlWindow& window_;
  const Protocol& protocol_;
  SessionFlow& flow_;
  ExperimenterConsole& console_;
  const SessionLoopOptions& options_;
  Exchange& exchange_;
  int64_t began_;  ///< of the steady clock
  TrialScreen screen_;
  double pixelsPerUnit_;
  Pace pace_;
  ClockWatch clock_;
  bool quits_ = false;
  bool hadFocus_ = false;
  bool turning_ = false;
  int64_t trialFrames_ = 0;
  int64_t statusShown_ = 0;
  std::string imaged_;
  int images_ = 0;
};

/// Until the thread that draws has ended.
void passEventsOn(GlWindow& window, Exchange& exchange, const SessionLoopOptions& options) {
  CursorMode cursor = CursorMode::kShown;
  const bool polls = options.responses != nullptr && options.responses->mustBePolled();
  while (!exchange.over) {
    std::vector<TimedWindowEvent> events = window.pollTimed(polls ? kDevicePollSeconds : kPollSeconds);
    if (polls) {
      options.responses->poll();
    }
    if (!events.empty()) {
      const std::scoped_lock lock(exchange.mutex);
      exchange.events.insert(exchange.events.end(), std::make_move_iterator(events.begin()),
                             std::make_move_iterator(events.end()));
    }
    if (const CursorMode wanted = exchange.cursor; wanted != cursor) {
      cursor = wanted;
      window.setCursor(cursor);
    }
    if (options.interrupted && options.interrupted()) {
      exchange.interrupted = true;
    }
  }
}

}  // namespace

SessionEnding runSessionLoop(GlWindow& window, const Protocol& protocol, SessionFlow& flow,
                             ExperimenterConsole& console, const SessionLoopOptions& options) {
  Exchange exchange;
  ScreenRenderer renderer(window, protocol, flow, console, options, exchange);
  std::exception_ptr failure;
  std::thread thread([&] {
    try {
      renderer.run();
    } catch (...) {
      failure = std::current_exception();
    }
    exchange.over = true;
    GlWindow::wake();
  });
  std::exception_ptr failureHere;
  try {
    passEventsOn(window, exchange, options);
  } catch (...) {
    failureHere = std::current_exception();
    exchange.interrupted = true;
  }
  thread.join();
  if (!failure) {
    failure = failureHere;
  }
  if (failure) {
    flow.abort("the program failed");
    std::rethrow_exception(failure);
  }
  return flow.ending();
}

}  // namespace ocelli
