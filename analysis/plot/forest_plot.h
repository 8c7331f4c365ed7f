// Estimates with their intervals, one below the other, with their numbers beside them: ratios on a log axis, or
// differences.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/plot/panel.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct ForestPlot {
  struct Row {
    std::string label;
    Interval interval{};
    bool heading = false;     ///< the label alone
    bool main = false;        ///< the result that the others are compared with
    std::string reason = {};  ///< in place of the numbers, why there are none
  };

  std::string title;
  std::string valueLabel;  ///< "Ratio of times, bent / flat"
  std::string lowerSide;   ///< left of the reference: "bent faster"
  std::string upperSide;
  std::vector<Row> rows;
  bool ratio = false;                                ///< log axis and reference 1, else reference 0
  std::optional<std::array<double, 2>> equivalence;  ///< shaded: differences that do not matter
  double widthMillimetres = kDoubleColumnMillimetres;
};

/// An interval that is far wider than the others ends in an arrow at the edge; its numbers say where it goes.
Figure forestFigure(const ForestPlot& plot);

}  // namespace ocelli
