// A session as it runs: consent, forms, instructions, practice, trials, breaks, survey. Input and frames go in, what to
// show comes out, records go to a sink. It knows neither windows nor clocks: whoever runs it (a screen, a simulation, a
// test) brings the events with the times when they came, and tells when each frame was shown.
//
//   SessionFlow flow(protocol, schedule, done, screen, sink);
//   while (!flow.isOver()) {
//     for (event : ...) flow.handle({event, nanoseconds});
//     flow.update(now);                 // trials take what came before `now`, and their ticks pass
//     draw(flow.screen());
//     flow.frameShown(nanoseconds);     // when the frame was on the screen
//   }
//
// Everything can be done by keys alone: Enter goes on, arrows and digits choose, texts are typed; F10 is "I feel
// unwell". Where practice failed a person's Enter does nothing: the experimenter goes on, by resume() or F12. A key
// that is pressed again without having been released is a repeat: pages do not take it, so keys must be released.
//
// Ticks. A trial begins when its first frame is shown: that is tick 0. An event takes effect at the tick into which it
// falls; where that is over already (it came late, or a frame has shown that tick), at the next one. So a trial is the
// same again where, for t = 0, 1, 2, ..., one hands it the inputs of tick t in their order, then the frames of tick t,
// and then lets a tick pass.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/protocol/schedule.h"
#include "study/protocol/staircase_trials.h"
#include "study/session/session_screen.h"
#include "study/session/session_sink.h"
#include "study/task/timed_input.h"

namespace ocelli {

/// What was stored of this session before, for one that is resumed.
struct SessionDone {
  std::vector<int> completedTrials{};  ///< indices of plans
  std::vector<int> attempts{};         ///< how often each plan began; as long as the schedule, or empty
  bool consented = false;
  std::vector<std::string> forms{};        ///< names of those that were answered
  std::vector<int> blocksPracticed{};      ///< indices in the protocol
  std::vector<TrialPlan> practiceBegun{};  ///< of each practice trial that began
  AnsweredCases answered{};                ///< of the completed trials of the schedule: for staircases
};

struct SessionFlowOptions {
  TrialScreen screen{};
  int64_t intervalNanoseconds = 16'666'667;  ///< of the screen, as measured
  bool unstableRefresh = false;              ///< marks all trials
  bool simulatedClock = false;               ///< marks all trials
  SubjectKind kind = SubjectKind::kPerson;
  std::function<std::string()> utcNow{};  ///< for the records; the clock of the system where empty (utc_time.h)
};

/// What the subject does to a form or page by the mouse: what widgets report. To go on is what Enter does on a page, to
/// decline what Escape does.
struct FormAction {
  enum class Kind { kClick, kGoOn, kDecline };
  Kind kind = Kind::kGoOn;
  int item = 0;  ///< of FormScreen::items
  QuestionClick click{};
};

/// What an experimenter's console shows.
struct SessionStatus {
  std::string step;       ///< "trial 12 of 24, find stationary, gc, location 3"
  std::string blindStep;  ///< the same without what tells of a condition: "trial 12 of 24, find stationary"
  SessionProgress progress;
  bool paused = false;
  TrialTiming lastTiming{};  ///< of the last trial
  bool wantsExperimenter = false;
  bool ended = false;     ///< a last page is shown
  std::string failure{};  ///< why the session failed
};

/// Begins one trial of each block and view, so that what does not fit onto the screen is told before a subject sits
/// there. Throws InputError.
void tryTrials(const Protocol& protocol, const SessionSchedule& schedule, const TrialScreen& screen);

class SessionFlow {
 public:
  /// `protocol` and `sink` must outlive it. Throws InputError where something was done before and the protocol does not
  /// allow to resume, and where a task does not fit onto the screen.
  SessionFlow(const Protocol& protocol, const SessionSchedule& schedule, const SessionDone& done,
              const SessionFlowOptions& options, SessionSink& sink);
  ~SessionFlow();
  SessionFlow(const SessionFlow&) = delete;
  SessionFlow& operator=(const SessionFlow&) = delete;

  /// In the order in which they came. The tick at which a trial takes an event follows from when it came.
  void handle(const TimedInput& input);
  void act(const FormAction& action, int64_t nanoseconds);
  /// Samples of gaze that came since the last update, in order. Those of the trial that runs are stored with it, from
  /// its first frame on; others are of no trial, and are not kept. They change nothing in the session.
  void gaze(std::span<const GazeRecord> samples);
  /// Time has come to `nanoseconds`.
  void update(int64_t nanoseconds);
  /// The screen of the last update() was shown. `pixelHash` is of its trial image, where it was read.
  void frameShown(int64_t nanoseconds, std::optional<uint64_t> pixelHash = {});

  SessionScreen screen() const;
  bool isOver() const;
  SessionEnding ending() const;
  SessionStatus status() const;
  /// The trial that runs, for whoever simulates a subject; nothing between trials.
  const TrialRun* trial() const;
  std::optional<TrialPlan> trialPlan() const;

  // What the experimenter may do.
  void pause(const std::string& reason);
  /// Goes on after pause(), where the trial that was stopped comes again, or else after practice that failed.
  void resume();
  /// The trial that runs, or else the last, again. False where there is none, and once the session has ended.
  bool redo();
  /// Ends the session: a last page is shown until Enter, or until this is called again.
  void abort(const std::string& reason);
  /// False where it is not stored: the subject declined, or nothing can be stored any more.
  bool note(const std::string& text);
  /// Something that whoever runs the session noticed: "clock_jump", "monitor_lost", ...
  void report(const std::string& what, const std::string& detail);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ocelli
