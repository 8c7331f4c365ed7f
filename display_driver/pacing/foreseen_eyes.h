// The eyes that a tracker tells live, foreseen (eye_predictor.h), and how far what was foreseen was off.
#pragma once

#include <deque>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "display_driver/pacing/eye_feed.h"
#include "display_driver/pacing/eye_predictor.h"
#include "display_sim/observing/eye_path.h"

namespace ocelli {

class ForeseenEyes {
 public:
  explicit ForeseenEyes(EyePrediction how) : predictor_(how) {}

  /// A pose with the tracker's time, and when it came.
  void add(const EyePose& pose, HostTime arrival);
  std::optional<glm::vec3> at(HostTime seen);
  PredictionErrors errors() const;

 private:
  struct Place {
    HostTime time;
    glm::vec3 eye;
  };
  struct Foreseen {
    Place place;
    Place last;  ///< sample then
  };

  HostTime timeOf(const EyePose& pose, HostTime arrival);

  EyePredictor predictor_;
  std::optional<Place> last_;
  std::optional<double> lastTold_;                         ///< the tracker's time of the last pose, seconds
  std::optional<std::chrono::duration<double>> offset_{};  ///< of the host's time from the tracker's
  std::deque<Foreseen> open_;                              ///< what is not known yet
  std::vector<float> off_;
  std::vector<float> offLast_;
  std::vector<float> ahead_;
};

}  // namespace ocelli
