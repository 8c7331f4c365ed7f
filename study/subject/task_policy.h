// What a simulated observer does in a trial of one task. It lives from one fixation to the next: the eye rests on a
// point of the screen, what it saw there is known at the end of the fixation, and then the motor model is told what to
// do.
//
// Recipe for the policy of another task, two places:
//   1. study/subject/NAME_policy.h and .cpp: a class of this kind.
//   2. study/subject/session_observer.cpp: one line.
#pragma once

#include "study/subject/motor_model.h"
#include "study/subject/vision.h"

namespace ocelli {

class TaskPolicy {
 public:
  virtual ~TaskPolicy() = default;

  /// Whether floors matter to it.
  virtual bool wantsFloor() const = 0;
  /// `seen` was on the screen at `from`, when the fixation began; it ends at `now`. Returns how much longer than a
  /// fixation it takes to make something of it, seconds.
  virtual double think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) = 0;
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
