// How a simulated observer matches a path: while it is played back it notices turns by how what it sees moves across
// the image, and remembers them with the times between them, as well as it can; then it compares them with the
// maps.
#pragma once

#include "study/agent/task_policy.h"

namespace ocelli {

class PathPolicy final : public TaskPolicy {
 public:
  PathPolicy(const Vision& vision, uint64_t seed) : vision_(vision), random_(seed) {}

  bool wantsFloor() const override { return true; }
  double think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) override;
  /// How unlike the map that was chosen is to what is remembered; less is surer.
  double effort(double /*seconds*/) const override { return effort_; }

  /// As it is remembered: 1 for a turn to the right, -1 for one to the left.
  struct Turn {
    int side = 1;
    double secondsBefore = 0;  ///< since the turn before, or the start
  };
  const std::vector<Turn>& turns() const { return turns_; }

 private:
  void watch(const Percept& seen, int64_t from);
  /// By how much the image turned since the last fixation, degrees to the right; nothing where nothing tells.
  std::optional<double> turnedDegrees(const Percept& seen) const;
  void noteTurn(double degrees, int64_t at);
  double mismatch(const SeenMap& map) const;
  void answer(const Percept& seen, int64_t now, MotorModel& motor);

  Vision vision_;
  Random random_;
  std::vector<SurfaceSpot> before_{};
  double turning_ = 0;  ///< degrees of the turn under way
  int64_t began_ = -1;
  int64_t lastTurn_ = -1;
  std::vector<Turn> turns_{};
  double effort_ = 0;
  int64_t answersAgainAt_ = 0;
};

}  // namespace ocelli
