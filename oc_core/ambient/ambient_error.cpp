#include "oc_core/ambient/ambient_error.h"

#include <cmath>

#include "oc_core/base/check.h"

namespace ocelli {

AmbientError ambientError(std::span<const float> light, std::span<const float> truth) {
  OC_CHECK(light.size() == truth.size(), "light of other points");
  AmbientError error;
  error.points = light.size();
  if (light.empty()) {
    return error;
  }
  for (size_t i = 0; i < light.size(); ++i) {
    const double off = static_cast<double>(light[i]) - static_cast<double>(truth[i]);
    error.signedMean += off;
    error.rmse += off * off;
    error.wrongShare += std::abs(off) > AmbientError::kWrong ? 1 : 0;
  }
  const auto count = static_cast<double>(light.size());
  error.signedMean /= count;
  error.rmse = std::sqrt(error.rmse / count);
  error.wrongShare /= count;
  return error;
}

}  // namespace ocelli
