// Runs sessions of a subject until all are done, and says on standard output what was acknowledged. kill_harness.h
// kills it.
//
// Usage: study_store_kill_child DATABASE SUBJECT
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <thread>

#include "oc_core/base/random.h"
#include "study/session/utc_time.h"
#include "study/store/resume.h"
#include "study/store/trial_store.h"
#include "tests/study_session/session_harness.h"
#include "tests/study_store/kill_study.h"

namespace ocelli::test {
namespace {

constexpr std::chrono::microseconds kPause{300};

/// One line, in one piece.
void say(const std::string& line) {
  const std::string bytes = line + "\n";
  if (write(STDOUT_FILENO, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    _exit(3);
  }
}

/// Hands everything on to the store, and says which trials that acknowledged.
class SayingSink final : public FakeSink {
 public:
  explicit SayingSink(SessionSink& store) : store_(store) {}

  void consent(const ConsentRecord& record) override { store_.consent(record); }
  void answer(const AnswerRecord& record) override { store_.answer(record); }
  void trialBegins(int number, const TrialPlan& plan, int attempt) override {
    digest_ = {};
    store_.trialBegins(number, plan, attempt);
  }
  void frames(int number, std::span<const FrameRecord> records) override {
    for (const FrameRecord& record : records) {
      digest_.add(record);
    }
    store_.frames(number, records);
  }
  void inputs(int number, std::span<const InputRecord> records) override {
    for (const InputRecord& record : records) {
      digest_.add(record);
    }
    store_.inputs(number, records);
  }
  void gaze(int number, std::span<const GazeRecord> records) override {
    for (const GazeRecord& record : records) {
      digest_.add(record);
    }
    store_.gaze(number, records);
  }
  void trialEnds(int number, const TrialRecord& record, std::function<void()>) override {
    const AcknowledgedTrial trial{record.plan.index,     record.attempt,        record.plan.practice,
                                  nameOf(record.ending), record.outcome.answer, digest_.value()};
    store_.trialEnds(number, record, [line = lineOf(trial)] { say(line); });
  }
  void event(const EventRecord& record) override { store_.event(record); }
  void sessionEnds(SessionEnding ending, const std::string& utc) override { store_.sessionEnds(ending, utc); }
  void flush() override { store_.flush(); }
  std::optional<std::string> failure() const override { return store_.failure(); }

 private:
  SessionSink& store_;
  TrialDigest digest_;
};

/// A whole session, or what is left of it: forms and pages by keys, trials of 30 to 110 frames with keys and moves of
/// the mouse.
void runSession(const Protocol& protocol, const SessionSchedule& schedule, const SessionDone& done, SayingSink& sink,
                uint64_t seed) {
  Random random(seed);
  SessionRun run(protocol, schedule, sink, done);
  while (!run.flow.isOver()) {
    run.goOn([&] { return run.inTrial(); });
    const size_t frames = 30 + random.below(80);
    for (size_t frame = 0; run.inTrial() && frame < frames; ++frame) {
      run.frame();
      const GazeRecord sample{run.now, static_cast<double>(frame), true, static_cast<double>(random.below(640)), 0, {}};
      run.flow.gaze(std::span(&sample, 1));
      // Slow enough for the log of a trial to come to the disk before the trial ends.
      std::this_thread::sleep_for(kPause);
      if (frame % 4 == 0) {
        run.input(PointerMoveEvent{static_cast<double>(random.below(640)), static_cast<double>(random.below(480))});
      }
    }
    if (run.inTrial()) {
      run.answerTrial();
    }
  }
}

void runSubject(const std::string& path, const std::string& subject) {
  const Protocol protocol = killProtocol();
  StudyDatabase database = StudyDatabase::openForSessions(path, protocol, {.minFreeBytes = 0});
  if (!database.subject(subject)) {
    database.addSubject(subject, SubjectKind::kPerson);
  }
  const int slot = database.subject(subject)->slot;
  for (int session = 1; session <= protocol.sessions; ++session) {
    if (const auto stored = database.session(subject, session); stored && stored->ending == SessionEnding::kCompleted) {
      continue;
    }
    const SessionToRun next = sessionToRun(database, protocol, subject, utcNow());
    if (next.session != session) {
      throw std::runtime_error("another session was to come next");
    }
    say(fmt::format("resumes {} {}", session, next.done.completedTrials.size()));
    const SessionSchedule schedule = scheduleOf(protocol, slot, session, next.seed);
    RunRecord record;
    record.subject = subject;
    record.slot = slot;
    record.session = session;
    record.startedUtc = utcNow();
    record.station = "kill test";
    TrialStore store(database, protocol, record, schedule, {.flushSeconds = 0.003});
    SayingSink sink(store);
    runSession(protocol, schedule, next.done, sink, next.done.completedTrials.size() + 1);
    store.flush();
    if (store.failure()) {
      throw std::runtime_error(*store.failure());
    }
  }
  say("done");
}

}  // namespace
}  // namespace ocelli::test

int main(int count, char** arguments) {
  if (count != 3) {
    return 2;
  }
  try {
    ocelli::test::runSubject(arguments[1], arguments[2]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kill_child: %s\n", error.what());
    return 1;
  }
}
