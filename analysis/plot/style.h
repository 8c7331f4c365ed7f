// How figures look: sizes that can be read in print.
#pragma once

#include <cstddef>

#include "oc_core/drawing/series_style.h"

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

inline constexpr Paint kTextPaint = paintOf(page_color::kText);
inline constexpr Paint kSoftTextPaint = paintOf(page_color::kSoft);
inline constexpr Paint kAxisPaint = paintOf(page_color::kSoft);
inline constexpr Paint kGridPaint = paintOf(page_color::kGrid);
inline constexpr Paint kWhite{1, 1, 1};
inline constexpr Paint kReferencePaint = paintOf(page_color::kSoft);

/// Raw points must not hide each other: the more there are, the fainter.
double pointOpacity(size_t points);

}  // namespace ocelli
