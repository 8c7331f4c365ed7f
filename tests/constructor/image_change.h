// By how much images change from frame to frame: the mean absolute difference of linear colours.
#pragma once

#include <algorithm>
#include <cstdio>
#include <glm/common.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/render/fragment_image.h"

namespace ocelli::test {

inline double meanDifference(const Image<glm::vec3>& a, const Image<glm::vec3>& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const glm::vec3 difference = glm::abs(a[i] - b[i]);
    sum += static_cast<double>(difference.x + difference.y + difference.z) / 3;
  }
  return sum / static_cast<double>(a.size());
}

/// Each pixel the mean of samples x samples: what is finer than a pixel counts as what it looks like.
inline Image<glm::vec3> averaged(const Image<glm::vec3>& fine, int samples) {
  Image<glm::vec3> coarse(fine.width() / samples, fine.height() / samples, glm::vec3(0));
  for (int y = 0; y < coarse.height() * samples; ++y) {
    for (int x = 0; x < coarse.width() * samples; ++x) {
      coarse(x / samples, y / samples) += fine(x, y) / static_cast<float>(samples * samples);
    }
  }
  return coarse;
}

class ImageChange {
 public:
  /// Of images that are so many times as wide and high.
  explicit ImageChange(int samples = 1) : samples_(samples) {}

  /// From the frame before; nothing for the first.
  std::optional<double> next(const FragmentImage& fragments, const Mesh& mesh) {
    Image<glm::vec3> colors = averaged(colorImage(fragments, mesh, glm::vec3(0)), samples_);
    const std::optional<double> change = last_.empty() ? std::nullopt : std::optional(meanDifference(last_, colors));
    last_ = std::move(colors);
    return change;
  }

 private:
  int samples_;
  Image<glm::vec3> last_;
};

/// Prints how a measure is distributed.
inline void report(const std::string& what, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1))];
  };
  const auto over = std::count_if(values.begin(), values.end(), [](double value) { return value > 1; });
  std::printf("%s (%zu): median %.3f, 90 %% %.3f, 99 %% %.3f, most %.3f; above 1: %td\n", what.c_str(), values.size(),
              at(0.5), at(0.9), at(0.99), at(1), static_cast<std::ptrdiff_t>(over));
}

}  // namespace ocelli::test
