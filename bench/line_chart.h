// Curves of a measurement, both axes in powers of ten, for pages of results.
#pragma once

#include <string>
#include <vector>

#include "oc_core/drawing/drawing.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct LineChart {
  struct Curve {
    std::string name;
    std::vector<PlotPoint> points;  ///< x and y are values
  };
  std::string title;
  std::string xLabel;
  std::string yLabel;
  std::vector<Curve> curves;
};

Figure lineFigure(const LineChart& chart);

}  // namespace ocelli
