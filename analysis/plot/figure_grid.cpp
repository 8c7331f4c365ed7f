#include "analysis/plot/figure_grid.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/plot/chart_text.h"

namespace ocelli {
namespace {

constexpr double kTitleHeight = 15;

}  // namespace

double FigureGrid::columnMillimetres() const {
  const double gaps = static_cast<double>(columns - 1) * kGridGapPoints / kPointsPerMillimetre;
  return (widthMillimetres - gaps) / static_cast<double>(columns);
}

Figure gridFigure(const FigureGrid& grid) {
  if (grid.figures.empty()) {
    return emptyFigure(grid.title, grid.widthMillimetres, "there is nothing to show");
  }
  Figure figure{grid.title, "", grid.widthMillimetres * kPointsPerMillimetre, 0, {}};
  double top = drawLegend(figure.drawing, {0, 0, figure.width, 0}, grid.legend);
  const double step = grid.columnMillimetres() * kPointsPerMillimetre + kGridGapPoints;
  for (size_t first = 0; first < grid.figures.size(); first += grid.columns) {
    double height = 0;
    for (size_t i = first; i < std::min(first + grid.columns, grid.figures.size()); ++i) {
      const Figure& each = grid.figures[i];
      const double left = static_cast<double>(i - first) * step;
      figure.drawing.text("chart title", {left, top},
                          shortened(each.title, Face::kSansBold, kTextSize, step - kGridGapPoints),
                          {.face = Face::kSansBold, .paint = kTextPaint, .down = Down::kTop});
      figure.drawing.add(each.drawing, {left, top + kTitleHeight});
      figure.description +=
          fmt::format("{}{}. {}", figure.description.empty() ? "" : " ", each.title, each.description);
      height = std::max(height, each.height);
    }
    top += kTitleHeight + height + (first + grid.columns < grid.figures.size() ? kGridGapPoints : 0);
  }
  figure.height = top;
  return figure;
}

}  // namespace ocelli
