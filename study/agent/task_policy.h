// What a simulated observer does in a trial of one task. It lives from one fixation to the next: the eye rests on a
// point of the screen, what it saw there is known at the end of the fixation, and then the motor model is told what to
// do. A task's row (study/tasks/task_registry.h) makes its policy.
#pragma once

#include <functional>

#include "study/agent/maze_memory.h"
#include "study/agent/motor_model.h"
#include "study/agent/vision.h"

namespace ocelli {

class TaskPolicy {
 public:
  virtual ~TaskPolicy() = default;

  /// Whether floors matter to it.
  virtual bool wantsFloor() const = 0;
  /// `seen` was on the screen at `from`, when the fixation began; it ends at `now`. Returns how much longer than a
  /// fixation it takes to make something of it, seconds.
  virtual double think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) = 0;
  /// How hard the trial was, which took that many seconds; less is better. Of tasks whose outcome is a time, its
  /// logarithm.
  virtual double effort(double seconds) const = 0;
};

/// What a policy is made for: one trial of one subject.
struct PolicySetting {
  const Vision& vision;
  const Controls& controls;
  std::function<MazeMemory&()> memory;  ///< of the maze that the first layout shows; it outlives the trial
  uint64_t seed = 1;
};

/// What a subject tells of a kind of trials afterwards: less is better.
struct Effort {
  double sum = 0;
  int trials = 0;

  void add(double effort) {
    sum += effort;
    ++trials;
  }
  double mean() const { return trials > 0 ? sum / trials : 0; }
};

}  // namespace ocelli
