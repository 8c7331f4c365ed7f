// Tasks of a study (section 7.3): what a subject is asked to do in a trial.
//
// A TaskBlock is what a block of a protocol says of its task: the cases, such as where the object stands, and how long
// they last. A TrialRun is one trial as it runs: input goes in, layouts come out, and in the end an outcome. It knows
// neither windows nor clocks nor files: time passes in ticks, so the same input at the same ticks gives the same poses,
// layouts and outcome, bit by bit, whether a person, a simulated subject or a log gives it.
//
// The tasks themselves are the rows of study/tasks/task_registry.h, which has the recipe for a new one.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "oc_core/base/input_event.h"
#include "study/task/controls.h"
#include "study/task/scene_view.h"
#include "study/task/trial_layout.h"
#include "study/task/trial_plan.h"

namespace ocelli {

/// Steps in which the time of a trial passes.
inline constexpr int64_t kTicksPerSecond = 240;

/// Ticks over since a trial began, both times in nanoseconds of the same clock.
constexpr int64_t ticksBetween(int64_t began, int64_t now) {
  // Whole seconds first: a product of all nanoseconds would overflow after years.
  constexpr int64_t kNanosecondsPerSecond = 1'000'000'000;
  const int64_t since = now > began ? now - began : 0;
  return since / kNanosecondsPerSecond * kTicksPerSecond +
         since % kNanosecondsPerSecond * kTicksPerSecond / kNanosecondsPerSecond;
}

/// Where the subject stands, in the coordinates of the maze: x to the east, z to the south.
struct WalkerPose {
  double x = 0;
  double z = 0;
  double headingRadians = 0;  ///< clockwise, seen from above; 0 is north, -z

  bool operator==(const WalkerPose&) const = default;
};

/// What a case is, for schedules, tables and exports. What does not apply is empty.
struct CaseInfo {
  std::string label;  ///< unique within the block: "location 3"
  bool moving = false;
  std::optional<double> exposureSeconds{};
  std::optional<int> objects{};
  std::optional<bool> duplicateColors{};
  double longestSeconds = 0;  ///< until the trial ends by itself, answering included where that is limited
  double typicalSeconds = 0;  ///< for the length of a schedule
  /// Of the stimulus, of cases of a staircase: the greater, the easier.
  std::optional<double> level{};
};

struct TrialOutcome {
  std::string answer;    ///< what was answered; empty where nothing was
  std::string expected;  ///< what would have been right
  bool correct = false;
  bool censored = false;  ///< time ran out before the answer
  /// From the first tick to the answer; to the end of the time where it ran out. Of tasks with an exposure, from its
  /// end: from the tick of the first frame without the scene. Like every frame that one is seen some time after its
  /// tick (FrameRecord), about an interval of the screen.
  int64_t responseTicks = 0;
  int64_t exposureFrames = 0;                ///< frames that showed the scene, of tasks with an exposure
  std::optional<int64_t> exposureTicks{};    ///< from the first of these to the first that did not, by the clock
  std::map<std::string, double> measures{};  ///< what else is to be told: "path_length_m", ...

  bool operator==(const TrialOutcome&) const = default;
};

class TrialRun {
 public:
  virtual ~TrialRun() = default;

  /// Something happens at this tick. Events of no use to the task are ignored.
  virtual void handle(const InputEvent& event) = 0;
  /// A tick passes. Nothing happens any more once there is an outcome.
  virtual void advance() = 0;
  /// The layout has come to the screen, as one frame, at that tick: 0 for the first.
  virtual void frameShown(int64_t tick) = 0;

  virtual TrialLayout layout() const = 0;
  virtual WalkerPose pose() const = 0;
  /// Once the trial is over.
  virtual std::optional<TrialOutcome> outcome() const = 0;
};

class TaskBlock {
 public:
  virtual ~TaskBlock() = default;

  virtual int caseCount() const = 0;
  virtual CaseInfo caseInfo(int caseIndex) const = 0;
  /// Whether neither the subject nor an object moves while the scene shows.
  virtual bool isStill() const { return false; }
  /// The right answer of a case, for the schedule that `study check` prints: "object at row 2, column 5", "6", ...
  virtual std::string answerOf(const TrialPlan& plan) const = 0;
  /// Of how many answers one is right, each as likely to be guessed; 0 where that cannot be said.
  virtual int choiceCount() const { return 0; }
  /// The block must outlive the run.
  virtual std::unique_ptr<TrialRun> start(const TrialPlan& plan, const TrialScreen& screen) const = 0;
};

/// What all blocks of a protocol share.
struct TaskSetting {
  std::map<std::string, Maze> mazes{};  ///< by name; valid, without landmarks
  Controls controls{};
  StudyConditions conditions{};
};

}  // namespace ocelli
