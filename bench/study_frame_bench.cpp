// Whether the logging of a session makes frames late: a session of find trials at 60 frames a second in real time,
// stored as always; each frame's time in the logic, the part of it within the store's calls, and how late it was.
//
// The session draws nothing, and its frames end by sleeping: what is late here is late by the logic, the store or the
// machine. A frame counts as late because of logging where it is late and the store's calls took more than a tenth of
// its interval.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "study/session/session_flow.h"
#include "study/store/trial_store.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Choice {
  std::string folder = ".";
  double minutes = 10;
};

constexpr double kHertz = 60;

double microsecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

/// Hands everything on, and adds up the time that it takes.
class TimedSink final : public SessionSink {
 public:
  explicit TimedSink(SessionSink& sink) : sink_(sink) {}
  double takeMicroseconds() { return std::exchange(microseconds_, 0.0); }

  void consent(const ConsentRecord& record) override {
    timed([&] { sink_.consent(record); });
  }
  void answer(const AnswerRecord& record) override {
    timed([&] { sink_.answer(record); });
  }
  void trialBegins(int number, const TrialPlan& plan, int attempt) override {
    timed([&] { sink_.trialBegins(number, plan, attempt); });
  }
  void frames(int number, std::span<const FrameRecord> records) override {
    timed([&] { sink_.frames(number, records); });
  }
  void inputs(int number, std::span<const InputRecord> records) override {
    timed([&] { sink_.inputs(number, records); });
  }
  void gaze(int number, std::span<const GazeRecord> records) override {
    timed([&] { sink_.gaze(number, records); });
  }
  void trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) override {
    timed([&] { sink_.trialEnds(number, record, std::move(acknowledged)); });
  }
  void event(const EventRecord& record) override {
    timed([&] { sink_.event(record); });
  }
  void sessionEnds(SessionEnding ending, const std::string& utc) override {
    timed([&] { sink_.sessionEnds(ending, utc); });
  }
  void flush() override { sink_.flush(); }
  std::optional<std::string> failure() const override { return sink_.failure(); }

 private:
  template <class Call>
  void timed(const Call& call) {
    const Clock::time_point start = Clock::now();
    call();
    microseconds_ += microsecondsSince(start);
  }

  SessionSink& sink_;
  double microseconds_ = 0;
};

/// Trials of 3 s, enough for so long.
Protocol protocolFor(double minutes) {
  std::string cases;
  for (int i = 0; i < std::max(2, static_cast<int>(minutes * 60 / 3 / 2) + 1); ++i) {
    cases += fmt::format(R"({}{{"label": "{}", "row": 0, "column": 2}})", cases.empty() ? "" : ",", i + 1);
  }
  return protocolFromJsonText(fmt::format(R"({{"name": "bench", "title": "bench",
        "mazes": {{"maze": {{"plan": ["+-+-+-+", "|     |", "+ +-+ +", "|     |", "+ + +-+", "| |   |", "+-+ +-+"]}}}},
        "blocks": [{{"name": "find", "title": "Find", "task": "find", "maze": "maze", "limit_seconds": 3,
          "order": "alternating", "views": "both", "break_after": false,
          "instructions": [{{"title": "Find", "paragraphs": ["Find it."]}}], "cases": [{}]}}]}})",
                                          cases),
                              "study_frame_bench");
}

struct Frames {
  std::vector<double> store;  ///< microseconds of each frame
  std::vector<double> logic;
  size_t late = 0;
  size_t lateByStore = 0;
};

Frames runSession(const Protocol& protocol, TimedSink& sink, const SessionSchedule& schedule, double minutes) {
  SessionFlowOptions options;
  options.screen = {1280, 800, kHertz};
  options.kind = SubjectKind::kGenerator;
  SessionFlow flow(protocol, schedule, {}, options, sink);
  Frames frames;
  Random random(1);
  const Clock::time_point start = Clock::now();
  const auto interval = std::chrono::nanoseconds(options.intervalNanoseconds);
  const auto now = [&] { return std::chrono::nanoseconds(Clock::now() - start).count(); };
  bool held = false;
  for (int64_t frame = 1; !flow.isOver() && static_cast<double>(frame) < minutes * 60 * kHertz; ++frame) {
    const Clock::time_point due = start + frame * interval;
    // Keys as someone who explores presses them: one change in five frames; in between trials, Enter.
    const Clock::time_point begin = Clock::now();
    if (frame % 5 == 0) {
      const Key key =
          flow.trial() == nullptr ? Key::kEnter : std::array{Key::kW, Key::kLeft, Key::kRight}[random.below(3)];
      held = !held;
      flow.handle({KeyEvent{key, held, {}}, now()});
    }
    flow.update(now());
    flow.screen();
    flow.frameShown(now());
    frames.logic.push_back(microsecondsSince(begin));
    frames.store.push_back(sink.takeMicroseconds());
    std::this_thread::sleep_until(due);
    const double over = std::chrono::duration<double>(Clock::now() - due).count() * kHertz;
    const bool isLate = over > protocol.timing.lateFactor - 1;
    frames.late += isLate ? 1 : 0;
    frames.lateByStore += isLate && frames.store.back() > 0.1 * 1e6 / kHertz ? 1 : 0;
  }
  return frames;
}

void measure(const Choice& choice) {
  const fs::path folder = fs::path(choice.folder) / "ocelli_frame_bench";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const Protocol protocol = protocolFor(choice.minutes);
  StudyDatabase database = StudyDatabase::openForSessions(folder / "bench.db", protocol);
  RunRecord run;
  run.subject = database.addSubject("bench", SubjectKind::kGenerator).id;
  run.kind = SubjectKind::kGenerator;
  const SessionSchedule schedule = scheduleOf(protocol, 0, 1, 1);
  TrialStore store(database, protocol, run, schedule);
  TimedSink sink(store);
  Frames frames = runSession(protocol, sink, schedule, choice.minutes);
  store.flush();
  if (const std::optional<std::string> failure = store.failure()) {
    throw WorkError(*failure, folder.string(), "another folder");
  }
  const auto row = [](const std::string& what, std::vector<double>& times) {
    std::sort(times.begin(), times.end());
    const auto at = [&](double share) {
      return times[static_cast<size_t>(share * static_cast<double>(times.size() - 1))];
    };
    fmt::print("{:<40}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.1f}\n", what, at(0.5), at(0.99), at(0.9999), times.back());
  };
  fmt::print("{} frames at {} Hz, {} trials stored\n\n", frames.store.size(), kHertz, database.trials().size());
  fmt::print("{:<40}{:>10}{:>10}{:>10}{:>10}\n", "microseconds of a frame", "median", "99 %", "99.99 %", "longest");
  row("session, with the store's calls", frames.logic);
  row("the store's calls", frames.store);
  fmt::print("\nlate frames (over {} intervals): {}, because of logging: {}\n", protocol.timing.lateFactor, frames.late,
             frames.lateByStore);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::Choice choice;
  CLI::App program("Frames of a session that is stored.", "study_frame_bench");
  program.add_option("--folder", choice.folder, "Where to write")->capture_default_str();
  program.add_option("--minutes", choice.minutes, "How long")->check(CLI::Range(0.1, 240.0))->capture_default_str();
  CLI11_PARSE(program, argumentCount, arguments);
  try {
    ocelli::measure(choice);
    return 0;
  } catch (const ocelli::Error& error) {
    fmt::print(stderr, "study_frame_bench: error: {}\n", error.what());
    return 1;
  }
}
