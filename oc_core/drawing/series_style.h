// Series that are told apart by colour, marker and dash, in figures, plans and pages alike.
#pragma once

#include <cstddef>
#include <string_view>

#include "oc_core/drawing/drawing.h"

namespace ocelli {

struct SeriesStyle {
  Paint paint;
  Marker marker;
  Dash dash;
  std::string_view colorName = {};  ///< the custom property of a page: "vermilion" for var(--vermilion)
};

/// Seven differ in colour and marker, then they repeat.
SeriesStyle seriesStyle(size_t series);

}  // namespace ocelli
