// Where a tracked eye will be when what is made for it is seen: a tracker tells where it was, and by the time that a
// volume is made, sent and shown a head has gone on.
//
// Constant velocity: the straight line that fits the last samples best. Kalman: a filter of place and velocity for each
// axis, with random accelerations (R. E. Kalman, A New Approach to Linear Filtering and Prediction Problems, 1960); it
// also evens out what the tracker is off by.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "display_driver/device/device.h"

namespace ocelli {

enum class EyePrediction { kNone, kVelocity, kKalman };
/// "none", "velocity", "kalman"; in the order of the values.
std::vector<std::string> eyePredictionNames();
/// Throws InputError, naming `where`, for any other text.
EyePrediction eyePredictionFromName(const std::string& name, const std::string& where);

class EyePredictor {
 public:
  /// Nothing is foreseen beyond this: a head does not keep its velocity for longer.
  static constexpr std::chrono::milliseconds kMaxAhead{150};
  /// After a pause as long as this a head's motion is not what it was before.
  static constexpr std::chrono::milliseconds kMaxPause{250};

  explicit EyePredictor(EyePrediction how) : how_(how) {}

  /// Where the eye was, in display radii. A time that is not later than that of the last sample replaces its place.
  void add(HostTime time, const glm::vec3& eye);
  /// Where it will be. At the last sample for times before it, and for those long after it. Nothing before the first.
  std::optional<glm::vec3> at(HostTime time) const;

 private:
  struct Sample {
    HostTime time;
    glm::vec3 eye;
  };
  /// Of one axis: its mean, and how sure it is.
  struct Axis {
    double place = 0;
    double velocity = 0;
    double placeVariance = 0;
    double covariance = 0;
    double velocityVariance = 0;

    void goOn(double seconds);
    void see(double measured);
  };

  glm::dvec3 velocityOfLine() const;

  EyePrediction how_;
  std::deque<Sample> samples_;  ///< the last ones
  std::array<Axis, 3> axes_;
};

}  // namespace ocelli
