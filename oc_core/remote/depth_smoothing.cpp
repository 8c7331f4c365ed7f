#include "oc_core/remote/depth_smoothing.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// How far apart the neighbours of each round are: far ones level wide steps, near ones what is left.
constexpr int kSteps[] = {16, 8, 4, 4, 2, 2, 1, 1};
/// Three rounded values on a line are off it by at most this: half a level each, the middle one twice.
constexpr int kMaxBend = 2;

/// Whether the values beside `at`, a `step` away to either side, go on as it does.
bool isStraight(const uint16_t* at, std::ptrdiff_t step) {
  const int before = at[-step];
  const int after = at[step];
  return before > 0 && after > 0 && std::abs(before + after - 2 * *at) <= kMaxBend;
}

}  // namespace

Image<float> smoothedLevels(const Image<uint16_t>& values) {
  Image<float> now(values.width(), values.height());
  std::copy(values.begin(), values.end(), now.begin());
  Image<float> next = now;
  const std::ptrdiff_t row = values.width();
  const auto rows = static_cast<size_t>(values.height());
  for (const int step : kSteps) {
    const std::ptrdiff_t below = row * step;
    parallelFor(rows, 16, [&](size_t begin, size_t end) {
      for (size_t y = begin; y < end; ++y) {
        const bool hasRows = y >= static_cast<size_t>(step) && y + static_cast<size_t>(step) < rows;
        for (std::ptrdiff_t x = 0; x < row; ++x) {
          const size_t pixel = y * static_cast<size_t>(row) + static_cast<size_t>(x);
          const uint16_t* value = values.data() + pixel;
          const float* level = now.data() + pixel;
          if (*value == 0) {
            continue;
          }
          const bool across = x >= step && x + step < row && isStraight(value, step);
          const bool down = hasRows && isStraight(value, below);
          if (!across && !down) {
            continue;
          }
          const float sum = (across ? level[-step] + level[step] : 0) + (down ? level[-below] + level[below] : 0);
          const float middle = sum / (across && down ? 4.0f : 2.0f);
          next[pixel] = std::clamp(middle, static_cast<float>(*value) - 0.5f, static_cast<float>(*value) + 0.5f);
        }
      }
    });
    std::swap(now, next);
  }
  return now;
}

}  // namespace ocelli
