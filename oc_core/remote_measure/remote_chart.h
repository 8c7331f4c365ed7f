// Line charts on the page of `ocelli remote measure`, as inline SVG that takes its colours from the page.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ocelli {

struct ChartSeries {
  std::string name;
  std::vector<std::pair<double, double>> points;
  size_t style = 0;    ///< as in all figures (oc_core/drawing/series_style.h)
  bool isLine = true;  ///< its points are joined
  bool hasMarkers = false;
};

struct ChartAxis {
  std::string title;
  bool isLogarithmic = false;  ///< points that are not positive are left out
};

/// A chart with a legend below its title; a sentence where there is nothing to draw.
std::string remoteChart(const std::string& title, const ChartAxis& x, const ChartAxis& y,
                        const std::vector<ChartSeries>& series);

}  // namespace ocelli
