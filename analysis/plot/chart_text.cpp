#include "analysis/plot/chart_text.h"

#include <fmt/format.h>

#include <cmath>

namespace ocelli {

std::string intervalText(const Interval& interval, bool percent) {
  const auto text = [&](double value) { return percent ? percentText(value, 1) : shortNumberText(value); };
  if (!std::isfinite(interval.value)) {
    return "not known";
  }
  if (!std::isfinite(interval.lower) || !std::isfinite(interval.upper)) {
    return text(interval.value);
  }
  return fmt::format("{} ({} to {})", text(interval.value), text(interval.lower), text(interval.upper));
}

std::string listText(const std::vector<std::string>& items) {
  std::string text;
  for (size_t i = 0; i < items.size(); ++i) {
    text += i == 0 ? "" : i + 1 == items.size() ? " and " : ", ";
    text += items[i];
  }
  return text;
}

Figure emptyFigure(const std::string& title, double widthMillimetres, const std::string& reason) {
  constexpr double kHeight = 60;
  Figure figure{title, fmt::format("No data: {}.", reason), widthMillimetres * kPointsPerMillimetre, kHeight, {}};
  const PlotBox box{0.5, 0.5, figure.width - 0.5, kHeight - 0.5};
  figure.drawing.box("frame", box, std::nullopt, Pen{kAxisPaint, kThinLine, {2, 2}});
  drawNote(figure.drawing, box, fmt::format("No data: {}", reason));
  return figure;
}

bool isDrawable(double value, AxisScale scale) {
  return std::isfinite(value) && (scale == AxisScale::kLinear || value > 0);
}

}  // namespace ocelli
