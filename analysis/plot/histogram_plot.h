// How far counts were off, one panel for each view above the other: bars for whole errors, their numbers above them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/plot/panel.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct HistogramPlot {
  struct Series {
    std::string name;
    std::map<int, size_t> counts;  ///< how often each error was made
  };

  std::string title;
  std::string valueLabel = "Answer minus true number";
  std::vector<Series> series;
  double widthMillimetres = kSingleColumnMillimetres;
};

/// Errors of more than 8 stand at the ends, which the label of the axis then says.
Figure histogramFigure(const HistogramPlot& plot);

}  // namespace ocelli
