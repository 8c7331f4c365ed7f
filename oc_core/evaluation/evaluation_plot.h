// The plots of the page of `ocelli evaluate`, as inline SVG. Errors are ratios on a logarithmic axis in percent; what
// is 0 stands in a row of its own below it. Series look as in all figures (oc_core/drawing/series_style.h).
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ocelli {

/// A point (x, y) with a label, or a curve. `style` picks colour, marker and dash; the same one in every plot.
struct PlotSeries {
  std::string name;
  std::vector<std::pair<double, double>> points;
  size_t style = 0;
};

/// One point a series: x is a count, on a logarithmic axis too. A dotted line leads along those that no other one
/// beats in both.
std::string frontierPlot(const std::string& title, const std::string& xTitle, const std::string& yTitle,
                         const std::vector<PlotSeries>& series);

/// x runs from 0 to 1.
std::string curvePlot(const std::string& title, const std::string& xTitle, const std::string& yTitle,
                      const std::vector<PlotSeries>& series);

}  // namespace ocelli
