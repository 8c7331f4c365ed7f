// How a simulated observer finds an object: it goes or turns to where it takes least time to see floor that it knows of
// and has not seen yet, over ways that it has seen; what shows in bent rays counts as seen. Once it has made out the
// object it stops, points at it and clicks; of what it caught but a glimpse, it goes back to where it saw it from.
#pragma once

#include <algorithm>
#include <cmath>

#include "study/agent/maze_memory.h"
#include "study/agent/task_policy.h"

namespace ocelli {

class FindPolicy final : public TaskPolicy {
 public:
  /// `memory` is of this maze and outlives the trial.
  FindPolicy(const Vision& vision, const Controls& controls, MazeMemory& memory, uint64_t seed);

  bool wantsFloor() const override { return true; }
  double think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) override;
  double effort(double seconds) const override { return std::log(std::max(seconds, 0.1)); }

 private:
  void learn(const Percept& seen, int64_t from);
  void noteWhetherItMoves(const glm::dvec2& place, int64_t from);
  /// For what one has made out, or caught a glimpse of.
  void stopFor(int64_t now, MotorModel& motor);
  void goFor(const Sighting& object, int64_t from, int64_t now, MotorModel& motor);
  void walk(const Percept& seen, int64_t from, int64_t now, MotorModel& motor);
  /// By way of these places, from where one will be at that time; `looksAtLast`: one but turns to the last of them.
  void walkTo(const std::vector<glm::dvec2>& corners, bool looksAtLast, const WalkerPose& pose, int64_t at,
              MotorModel& motor) const;
  /// What was made out and is out of sight: back to where it was seen from.
  void faceAgain(const Percept& seen, int64_t from, int64_t now, MotorModel& motor);
  /// With keys to hold meanwhile.
  void turn(double degrees, int64_t at, std::vector<MotorModel::Hold> holds, MotorModel& motor) const;
  int64_t turnTime(double degrees, const MotorModel& motor) const;
  void turnAround(int64_t at, MotorModel& motor) const;
  /// Where the object was seen, or else what is least time away from being seen. `cellSeconds`: to walk a cell.
  std::optional<MazeCell> chooseGoal(const std::map<MazeCell, MazeMemory::Way>& ways, double cellSeconds);
  void noteWhetherStuck(const Percept& seen, int64_t from, const MotorModel& motor);
  void lookOn(const Percept& seen);

  Vision vision_;
  Controls controls_;
  MazeMemory& memory_;
  Random random_;
  std::optional<glm::dvec2> gaze_{};
  int64_t since_ = 0;                       ///< what was seen before is to be seen again
  int64_t sure_ = 0;                        ///< of what was seen before one is not sure any more
  std::map<MazeCell, double> feltCosts_{};  ///< of going to each cell, as factors
  std::optional<MazeCell> goal_{};
  std::optional<MazeCell> next_{};  ///< on the way there
  double inSight_ = 0;              ///< seconds for which the object has been
  int missed_ = 0;                  ///< fixations since it was seen, once it was made out
  bool found_ = false;              ///< or was there a glimpse of it
  glm::dvec2 foundAt_{0};           ///< its place, metres
  WalkerPose foundFrom_{};
  std::optional<MazeCell> lead_{};  ///< where it was seen, once it is lost from sight
  int64_t stopsAt_ = 0;             ///< to walk, since it was found
  struct Seen {
    glm::dvec2 place{0};
    int64_t at = 0;
  };
  std::optional<Seen> before_{};  ///< the object on the screen, a fixation ago
  std::optional<Seen> first_{};   ///< the object in the maze, metres, when it was first seen
  std::optional<WalkerPose> stood_{};
  int64_t stoodAt_ = 0;
  int stuck_ = 0;
};

}  // namespace ocelli
