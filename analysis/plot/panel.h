// The area of a chart with its axes, and the row of its legend.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/plot/axis.h"
#include "analysis/plot/style.h"
#include "oc_core/drawing/drawing.h"

namespace ocelli {

/// Either numbers or named categories, which lie at 0, 1, 2 ...
struct AxisSpec {
  std::string title;  ///< with its unit: "Time to find (s)"
  AxisRange range;
  std::vector<std::string> categories;  ///< where not empty, `range` does not matter
  bool grid = true;                     ///< faint lines across the area

  static AxisSpec ofValues(std::string title, const AxisRange& range, bool grid = true);
  static AxisSpec ofCategories(std::string title, std::vector<std::string> categories);
};

/// An upright panel: x to the right, y upwards; the categories of a y axis go from the top down.
class Panel {
 public:
  /// Draws the axes inside `outer`, so that no label leaves it.
  Panel(Drawing& drawing, const PlotBox& outer, const AxisSpec& x, const AxisSpec& y);

  const PlotBox& area() const { return area_; }
  double x(double value) const { return x_->at(value); }
  double y(double value) const { return y_->at(value); }
  PlotPoint at(double xValue, double yValue) const { return {x(xValue), y(yValue)}; }
  const Axis& xAxis() const { return *x_; }
  const Axis& yAxis() const { return *y_; }
  /// Of a category, along x or y, in points.
  double categoryWidth() const { return categoryWidth_; }

 private:
  void drawX(const AxisSpec& spec, const std::vector<std::vector<std::string>>& names);
  void drawY(const AxisSpec& spec, const std::vector<std::vector<std::string>>& names, double titleX);

  Drawing& drawing_;
  PlotBox area_;
  std::optional<Axis> x_;
  std::optional<Axis> y_;
  double categoryWidth_ = 0;
};

struct LegendEntry {
  std::string name;
  SeriesStyle style = seriesStyle(0);
  bool marker = true;
  bool line = false;
  bool filled = true;
  double radius = kSummaryRadius;
};

/// From the left of `row`, in as many lines as it takes; its height comes back. None for no entries.
double drawLegend(Drawing& drawing, const PlotBox& row, const std::vector<LegendEntry>& entries);

/// A summary: a line from end to end with the marker at the value, on white so that it stands out from raw points. What
/// is not finite is left out.
struct Interval {
  double value = 0;
  double lower = 0;
  double upper = 0;
};
void drawUprightInterval(Drawing& drawing, const Panel& panel, double x, const Interval& interval,
                         const SeriesStyle& style);
void drawLevelInterval(Drawing& drawing, const Panel& panel, double y, const Interval& interval,
                       const SeriesStyle& style);

/// A line in the middle of a box that says why nothing is drawn there.
void drawNote(Drawing& drawing, const PlotBox& box, const std::string& note);

}  // namespace ocelli
