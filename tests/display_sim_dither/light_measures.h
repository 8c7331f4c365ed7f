// What tests of observers measure in images of light.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "oc_core/image/image.h"

namespace ocelli::test {

inline glm::dvec3 sumOf(const Image<glm::vec3>& image) {
  glm::dvec3 sum(0);
  for (const glm::vec3& pixel : image) {
    sum += glm::dvec3(pixel);
  }
  return sum;
}

/// Of one channel: where its light is, and its variance along rows and columns, in pixels.
struct Spread {
  glm::dvec2 center{0};
  glm::dvec2 variance{0};
};

inline Spread spreadOf(const Image<glm::vec3>& image, int channel = 0) {
  Spread spread;
  glm::dvec2 squares(0);
  double sum = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const double light = image(x, y)[channel];
      const glm::dvec2 at(x + 0.5, y + 0.5);
      sum += light;
      spread.center += at * light;
      squares += at * at * light;
    }
  }
  spread.center /= sum;
  spread.variance = squares / sum - spread.center * spread.center;
  return spread;
}

/// The mean of a channel over the square of pixels within `reach` of the middle.
inline double middleOf(const Image<glm::vec3>& image, int reach, int channel = 0) {
  double sum = 0;
  for (int y = image.height() / 2 - reach; y < image.height() / 2 + reach; ++y) {
    for (int x = image.width() / 2 - reach; x < image.width() / 2 + reach; ++x) {
      sum += static_cast<double>(image(x, y)[channel]);
    }
  }
  return sum / (4.0 * reach * reach);
}

}  // namespace ocelli::test
