// Two conditions of the same subjects: a dot each, joined by a line, so that one sees who gained; beside them the
// summaries with their intervals.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/plot/panel.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct PairedPlot {
  struct Pair {
    double first = 0;
    double second = 0;
  };

  std::string title;
  std::string valueLabel;
  std::array<std::string, 2> conditions{};
  std::vector<Pair> pairs;              ///< those with a value that cannot be drawn are left out, and counted
  std::array<Interval, 2> summaries{};  ///< NaN where not known
  std::string summaryName = "mean, 95 % interval";
  std::string pointName = "one subject";
  AxisScale scale = AxisScale::kLinear;
  bool fromZero = true;
  bool percent = false;
  double widthMillimetres = kSingleColumnMillimetres;
};

Figure pairedFigure(const PairedPlot& plot);

}  // namespace ocelli
