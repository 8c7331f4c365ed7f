// How far ambient light is from the truth, over all points of a view.
#pragma once

#include <cstddef>
#include <span>

namespace ocelli {

struct AmbientError {
  /// Light that is off by more counts as wrong.
  static constexpr double kWrong = 0.1;

  size_t points = 0;
  double rmse = 0;
  double signedMean = 0;  ///< light minus truth: positive where occluders are missed
  double wrongShare = 0;  ///< of the points, those off by more than kWrong
};

/// Both are of the same points. All is 0 without points.
AmbientError ambientError(std::span<const float> light, std::span<const float> truth);

}  // namespace ocelli
