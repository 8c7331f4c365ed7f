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

class ImageChange {
 public:
  /// From the frame before; nothing for the first.
  std::optional<double> next(const FragmentImage& fragments, const Mesh& mesh) {
    Image<glm::vec3> colors = colorImage(fragments, mesh, glm::vec3(0));
    const std::optional<double> change = last_.empty() ? std::nullopt : std::optional(meanDifference(last_, colors));
    last_ = std::move(colors);
    return change;
  }

 private:
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
