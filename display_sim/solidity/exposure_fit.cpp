#include "display_sim/solidity/exposure_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "display_sim/observing/observer.h"
#include "oc_core/base/parallel.h"
#include "oc_core/image/color.h"

namespace ocelli {
namespace {

/// The lit channels of all pixels; dark ones have the same error with any gain.
class GainError {
 public:
  GainError(const Image<glm::vec3>& light, const Image<Rgb8>& image) {
    for (size_t i = 0; i < light.size(); ++i) {
      for (int channel = 0; channel < 3; ++channel) {
        if (light[i][channel] > 0) {
          light_.push_back(light[i][channel]);
          wanted_.push_back(static_cast<float>(image[i][channel]) / 255);
        }
      }
    }
  }

  double operator()(double gain) const {
    constexpr size_t kChunks = 64;
    std::vector<double> sums(kChunks, 0);
    parallelChunks(light_.size(), kChunks, [&](size_t chunk, size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const float shown = srgbFromLinear(std::min(light_[i] * static_cast<float>(gain), 1.0f));
        sums[chunk] += std::pow(static_cast<double>(shown - wanted_[i]), 2);
      }
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
  }

 private:
  std::vector<float> light_;
  std::vector<float> wanted_;
};

/// Where a function of one minimum between two numbers has it: golden section search.
template <class Function>
double minimumBetween(double low, double high, const Function& function) {
  const double part = (std::sqrt(5.0) - 1) / 2;
  constexpr int kSteps = 20;  // leave 1/15000 of the interval
  double left = high - part * (high - low);
  double right = low + part * (high - low);
  double atLeft = function(left);
  double atRight = function(right);
  for (int step = 0; step < kSteps; ++step) {
    if (atLeft <= atRight) {
      high = right;
      right = std::exchange(left, right - part * (right - low));
      atRight = std::exchange(atLeft, function(left));
    } else {
      low = left;
      left = std::exchange(right, left + part * (high - left));
      atLeft = std::exchange(atRight, function(right));
    }
  }
  return (low + high) / 2;
}

}  // namespace

double fittedGain(const Image<glm::vec3>& light, const Image<Rgb8>& image) {
  if (std::ranges::none_of(light, [](const glm::vec3& pixel) { return pixel.x > 0 || pixel.y > 0 || pixel.z > 0; })) {
    return 1;
  }
  const GainError errorOf(light, image);
  const double middle = std::log2(automaticGain(light));
  const auto atLog = [&](double log) { return errorOf(std::exp2(log)); };
  // As values are cut off at white there may be several minima: look around in coarse steps first.
  constexpr int kReach = 8;  // factors of 2 to both sides
  int best = -kReach;
  double least = atLog(middle + best);
  for (int step = -kReach + 1; step <= kReach; ++step) {
    const double error = atLog(middle + step);
    if (error < least) {
      least = error;
      best = step;
    }
  }
  return std::exp2(minimumBetween(middle + best - 1, middle + best + 1, atLog));
}

}  // namespace ocelli
