// How figures look: sizes that can be read in print, and series that are told apart by colour, marker and dash.
//
//   Okabe and Ito 2008      Color Universal Design: colours that colour-blind people tell apart
#pragma once

#include <cstddef>

#include "analysis/plot/drawing.h"

namespace ocelli {

// Widths of columns in print.
inline constexpr double kSingleColumnMillimetres = 85;
inline constexpr double kDoubleColumnMillimetres = 170;

// Points.
inline constexpr double kTextSize = 8;  ///< no text of a figure is smaller
inline constexpr double kLineHeight = 10;
inline constexpr double kSummaryRadius = 3;
inline constexpr double kPointRadius = 1.7;
inline constexpr double kThinLine = 0.5;
inline constexpr double kLine = 0.9;
inline constexpr double kThickLine = 1.4;

inline constexpr Paint kTextPaint{0.11, 0.13, 0.15};
inline constexpr Paint kSoftTextPaint{0.34, 0.38, 0.42};  ///< 6.5 : 1 on white
inline constexpr Paint kAxisPaint{0.35, 0.38, 0.42};
inline constexpr Paint kGridPaint{0.90, 0.90, 0.88};
inline constexpr Paint kWhite{1, 1, 1};
inline constexpr Paint kReferencePaint{0.35, 0.38, 0.42};

struct SeriesStyle {
  Paint paint;
  Marker marker;
  Dash dash;
};

/// Six differ in colour and marker, then they repeat.
SeriesStyle seriesStyle(size_t series);

/// Raw points must not hide each other: the more there are, the fainter.
double pointOpacity(size_t points);

}  // namespace ocelli
