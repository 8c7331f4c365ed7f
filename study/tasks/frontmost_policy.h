// How a simulated observer says which of two things is in front: the one that shows whole, as the other is covered in
// part, and, where both show whole, the one that looks larger than such a thing is. It knows how the shapes look by
// themselves, and nothing of displays: where things shine through one another, what is covered does not tell.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "study/agent/task_policy.h"

namespace ocelli {

class FrontPolicy final : public TaskPolicy {
 public:
  FrontPolicy(const Vision& vision, uint64_t seed) : vision_(vision), random_(seed) {}

  bool wantsFloor() const override { return false; }
  double effort(double seconds) const override { return seconds; }
  double think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) override;

 private:
  Vision vision_;
  Random random_;
  std::optional<int64_t> began_{};
  glm::dvec2 gaze_{0};
  std::vector<double> evidence_{};  ///< that the left one is in front, by look
  int64_t answersAgainAt_ = 0;
};

/// How a shape shows by itself, seen level from far away.
struct WholeShape {
  double height = 0;        ///< in radii of the disc that it stands on
  double areaOfHeight = 0;  ///< of its silhouette, over the square of its height
};
WholeShape wholeShape(LandmarkShape shape);

}  // namespace ocelli
