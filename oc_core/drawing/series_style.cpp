#include "oc_core/drawing/series_style.h"

#include <array>

namespace ocelli {
namespace {

SeriesStyle styleOf(const PageColor& color, Marker marker, Dash dash) {
  return {paintOf(color), marker, std::move(dash), color.name};
}

}  // namespace

SeriesStyle seriesStyle(size_t series) {
  using namespace page_color;
  static const std::array<SeriesStyle, 7> kStyles{{
      styleOf(kVermilion, Marker::kSquare, {4, 1.8}),
      styleOf(kBlue, Marker::kCircle, {}),
      styleOf(kGreen, Marker::kTriangle, {1.2, 1.6}),
      styleOf(kPurple, Marker::kDiamond, {6, 1.6, 1.2, 1.6}),
      styleOf(kOchre, Marker::kTriangleDown, {2.5, 1.2}),
      styleOf(kText, Marker::kCross, {7, 2}),
      styleOf(kSky, Marker::kPlus, {3.5, 1, 1, 1}),
  }};
  return kStyles[series % kStyles.size()];
}

}  // namespace ocelli
