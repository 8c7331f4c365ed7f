// The subject's body in a maze (section 7.3.1): three degrees of freedom, forward and backward, to the sides, and pan.
#pragma once

#include <optional>

#include "study/task/floor_plan.h"
#include "study/task/held_keys.h"
#include "study/task/task.h"

namespace ocelli {

class Walker {
 public:
  /// Both must outlive it. `start` must be a place where one can stand.
  Walker(const FloorPlan& plan, const Controls& controls, const WalkerPose& start)
      : plan_(plan), controls_(controls), pose_(start) {}

  void handle(const InputEvent& event);
  void advance();

  const WalkerPose& pose() const { return pose_; }
  double pathMeters() const { return pathMeters_; }
  double turnedDegrees() const { return turnedDegrees_; }
  /// How often a wall came in the way: to go on along one counts once.
  int collisions() const { return collisions_; }

 private:
  void turn(double degrees);

  const FloorPlan& plan_;
  const Controls& controls_;
  WalkerPose pose_;
  HeldKeys held_;
  bool pans_ = false;  ///< the right button is held
  std::optional<double> mouseX_{};
  double pathMeters_ = 0;
  double turnedDegrees_ = 0;
  int collisions_ = 0;
  bool touches_ = false;
};

}  // namespace ocelli
