// How a simulated observer says where an object is, as a number: it takes the picture for one along straight rays and
// reads from it where the object seems to stand. It does not know of bent rays, so that what they do to an answer is
// what they do to the picture. Of several pictures side by side it takes each for one of what is straight ahead. No
// constant of it belongs to a condition.
#pragma once

#include <optional>

#include "study/agent/chance.h"
#include "study/agent/task_policy.h"

namespace ocelli {

/// Where an object seems to stand, seen from above, metres.
struct SeemingPlace {
  double ahead = 1;
  double right = 0;

  double meters() const { return std::hypot(ahead, right); }
  /// Clockwise from ahead, 0 to below 360.
  double degrees() const;
};

/// The focal length of a picture, pixels, as its floor tells: what is `right` of the line of sight and `ahead` shows
/// `focal * right / ahead` beside the middle. The median over the pieces of floor well to the sides that are seen along
/// rays that do not bend. Nothing where there are none, and of several pictures side by side.
std::optional<double> seemingFocalPixels(const Percept& seen);

/// By where the object stands in a picture whose rows are level and whose horizon is in its middle. At the horizon and
/// above it is far away: kFarMeters.
SeemingPlace seemingPlace(const Sighting& object, const PixelRect& view, double focalPixels, double eyeHeightMeters);
inline constexpr double kFarMeters = 100;

class EstimatePolicy final : public TaskPolicy {
 public:
  enum class Asked { kMeters, kDegrees };
  EstimatePolicy(Asked asked, const PolicySetting& setting)
      : asked_(asked), vision_(setting.vision), eyeHeight_(setting.controls.eyeHeightMeters), random_(setting.seed) {}

  bool wantsFloor() const override { return true; }
  double effort(double seconds) const override { return seconds; }
  double think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) override;

 private:
  void judge(const Percept& seen, int64_t from);
  void answer(const Percept& seen, int64_t now, MotorModel& motor);
  double estimateOf(const SeemingPlace& place);
  /// Where one would click to say so.
  glm::dvec2 markOf(const Percept& seen, double estimate) const;

  Asked asked_;
  Vision vision_;
  double eyeHeight_;
  Random random_;
  std::optional<int64_t> began_{};
  glm::dvec2 gaze_{0};
  std::optional<double> estimate_{};
  int64_t answersAgainAt_ = 0;
};

}  // namespace ocelli
