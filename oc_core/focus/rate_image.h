// Images of sampling rates.
#pragma once

#include <glm/vec2.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/image/image.h"

namespace ocelli {

/// At each pixel `rateAt(place)`, where the place is the pixel's centre, in pixels from the top left corner. It is
/// called on several threads.
template <class RateAt>
Image<float> rateImage(const glm::ivec2& size, const RateAt& rateAt) {
  constexpr size_t kRows = 4;  // at a time
  Image<float> rates(size.x, size.y);
  parallelFor(static_cast<size_t>(size.y), kRows, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      for (int x = 0; x < size.x; ++x) {
        rates(x, static_cast<int>(y)) = static_cast<float>(rateAt(glm::dvec2(x, y) + 0.5));
      }
    }
  });
  return rates;
}

}  // namespace ocelli
