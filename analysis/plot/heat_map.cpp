#include "analysis/plot/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/plot/axis.h"
#include "analysis/plot/chart_text.h"
#include "oc_core/drawing/color_scale.h"

namespace ocelli {
namespace {

constexpr double kMapGap = 12;
constexpr double kMapTitleHeight = 14;
constexpr double kLegendHeight = 38;
constexpr double kMaxHeight = 330;
constexpr int kShades = 64;  // of the legend

struct Extent {
  double left = std::numeric_limits<double>::infinity();
  double top = left;
  double right = -left;
  double bottom = -left;

  void take(double x, double y) {
    left = std::min(left, x);
    right = std::max(right, x);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  }
};

Extent extentOf(const HeatMap& map) {
  Extent extent;
  for (const HeatMap::Map& each : map.maps) {
    for (const HeatMap::Cell& cell : each.cells) {
      extent.take(cell.x - map.cellSize / 2, cell.y - map.cellSize / 2);
      extent.take(cell.x + map.cellSize / 2, cell.y + map.cellSize / 2);
    }
  }
  for (const auto& [x0, y0, x1, y1] : map.walls) {
    extent.take(x0, y0);
    extent.take(x1, y1);
  }
  return extent;
}

double shadeOf(const HeatMap& map, double value, double most) {
  const double share = most > 0 ? std::clamp(value / most, 0.0, 1.0) : 0;
  return map.rootScale ? std::sqrt(share) : share;
}

void drawMap(Drawing& drawing, const HeatMap& map, const HeatMap::Map& each, const Extent& extent, PlotPoint corner,
             double scale, double most) {
  const auto place = [&](double x, double y) {
    return PlotPoint{corner.x + scale * (x - extent.left), corner.y + scale * (y - extent.top)};
  };
  for (const HeatMap::Cell& cell : each.cells) {
    if (std::isfinite(cell.value)) {
      const PlotPoint from = place(cell.x - map.cellSize / 2, cell.y - map.cellSize / 2);
      const PlotPoint to = place(cell.x + map.cellSize / 2, cell.y + map.cellSize / 2);
      const Paint paint = scaleColor(shadeOf(map, cell.value, most));
      // Stroked in its own colour, so that no seams show between cells.
      drawing.box("cell", {from.x, from.y, to.x, to.y}, paint, Pen{paint, 0.3});
    }
  }
  for (const auto& [x0, y0, x1, y1] : map.walls) {
    drawing.line("wall", place(x0, y0), place(x1, y1), {kTextPaint, kLine});
  }
  for (const HeatMap::Mark& mark : each.marks) {
    const PlotPoint at = place(mark.x, mark.y);
    const double width = textWidth(mark.name, Face::kSansBold, kTextSize);
    // To the side where there is room.
    const bool leftwards = at.x + width + 8 > place(extent.right, 0).x;
    drawing.marker("mark", {at, Marker::kDiamond, 3.2, seriesStyle(0).paint, Pen{kWhite, kLine}});
    const double labelX = leftwards ? at.x - 6 - width : at.x + 6;
    drawing.box("mark ground", {labelX - 1.5, at.y - 5.5, labelX + width + 1.5, at.y + 5}, kWhite.faded(0.85));
    drawing.text("mark name", {labelX, at.y}, mark.name,
                 {.face = Face::kSansBold, .paint = kTextPaint, .down = Down::kMiddle});
  }
}

void drawScale(Drawing& drawing, const HeatMap& map, double width, double top, double most) {
  const double barWidth = std::min(200.0, width - 20);
  const double left = (width - barWidth) / 2;
  constexpr double kBar = 8;
  for (int i = 0; i < kShades; ++i) {
    const Paint paint = scaleColor((i + 0.5) / kShades);
    drawing.box("shade", {left + barWidth * i / kShades, top, left + barWidth * (i + 1) / kShades, top + kBar}, paint,
                Pen{paint, 0.3});
  }
  drawing.box("frame", {left, top, left + barWidth, top + kBar}, std::nullopt, Pen{kAxisPaint, kThinLine});
  AxisRange range;
  range.high = most > 0 ? most : 1;
  range.roundHigh = false;
  range.percent = map.percent;
  const Axis axis(range, 0, barWidth,
                  [](const std::string& label) { return textWidth(label, Face::kSans, kTextSize); });
  double end = -1e9;
  for (const AxisTick& tick : axis.ticks()) {
    const double x = left + barWidth * shadeOf(map, tick.value, range.high);
    const double half = textWidth(tick.label, Face::kSans, kTextSize) / 2;
    // The root of the values brings the ticks of its lower end together or apart.
    if (x - half > end + 3) {
      drawing.line("tick", {x, top + kBar}, {x, top + kBar + 2.5}, {kAxisPaint, kThinLine});
      drawing.text("tick label", {x, top + kBar + 4}, tick.label,
                   {.paint = kSoftTextPaint, .across = Across::kMiddle, .down = Down::kTop});
      end = x + half;
    }
  }
  drawing.text("axis title", {width / 2, top + kBar + 15}, map.valueLabel,
               {.paint = kTextPaint, .across = Across::kMiddle, .down = Down::kTop});
}

}  // namespace

Figure heatFigure(const HeatMap& map) {
  double most = 0;
  bool any = false;
  for (const HeatMap::Map& each : map.maps) {
    for (const HeatMap::Cell& cell : each.cells) {
      if (std::isfinite(cell.value)) {
        most = std::max(most, cell.value);
        any = true;
      }
    }
  }
  if (!any || !(map.cellSize > 0)) {
    return emptyFigure(map.title, map.widthMillimetres, "nobody was anywhere in the maze");
  }
  Figure figure{map.title,
                fmt::format("{}, cell by cell of the maze, from 0 (pale) to {} (dark).", map.valueLabel,
                            map.percent ? percentText(most, 1) : shortNumberText(most)),
                map.widthMillimetres * kPointsPerMillimetre,
                0,
                {}};
  const Extent extent = extentOf(map);
  const auto count = static_cast<double>(map.maps.size());
  const double mapWidth = (figure.width - 4 - kMapGap * (count - 1)) / count;
  const double scale = std::min(mapWidth / (extent.right - extent.left), kMaxHeight / (extent.bottom - extent.top));
  const double drawnWidth = scale * (extent.right - extent.left);
  const double drawnHeight = scale * (extent.bottom - extent.top);
  double left = 2;
  for (const HeatMap::Map& each : map.maps) {
    const PlotPoint corner{left + (mapWidth - drawnWidth) / 2, kMapTitleHeight};
    figure.drawing.text("map name", {corner.x, 0}, shortened(each.name, Face::kSansBold, kTextSize, mapWidth),
                        {.face = Face::kSansBold, .paint = kTextPaint, .down = Down::kTop});
    drawMap(figure.drawing, map, each, extent, corner, scale, most);
    const auto highest = std::max_element(each.cells.begin(), each.cells.end(), [](const auto& a, const auto& b) {
      return !std::isfinite(a.value) || (std::isfinite(b.value) && a.value < b.value);
    });
    if (highest != each.cells.end() && std::isfinite(highest->value)) {
      figure.description +=
          fmt::format(" {}: the most at {}, {}.", each.name, numberText(highest->x, 1), numberText(highest->y, 1));
    }
    left += mapWidth + kMapGap;
  }
  drawScale(figure.drawing, map, figure.width, kMapTitleHeight + drawnHeight + 8, most);
  figure.height = kMapTitleHeight + drawnHeight + 8 + kLegendHeight;
  return figure;
}

}  // namespace ocelli
