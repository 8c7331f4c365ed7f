#include "analysis/plot/style.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ocelli {

SeriesStyle seriesStyle(size_t series) {
  static const std::array<SeriesStyle, 6> kStyles{{
      {{0.835, 0.369, 0.0}, Marker::kSquare, {4, 1.8}},
      {{0.0, 0.447, 0.698}, Marker::kCircle, {}},
      {{0.0, 0.50, 0.37}, Marker::kTriangle, {1.2, 1.6}},
      {{0.68, 0.36, 0.55}, Marker::kDiamond, {6, 1.6, 1.2, 1.6}},
      {{0.72, 0.48, 0.0}, Marker::kTriangleDown, {2.5, 1.2}},
      {{0.15, 0.15, 0.15}, Marker::kCross, {7, 2}},
  }};
  return kStyles[series % kStyles.size()];
}

double pointOpacity(size_t points) {
  return std::clamp(4.5 / std::sqrt(static_cast<double>(std::max<size_t>(points, 1))), 0.18, 0.6);
}

}  // namespace ocelli
