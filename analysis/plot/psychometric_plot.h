// Shares of right answers by the level of a stimulus (a logarithmic axis), with fitted curves: a panel a condition.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/plot/panel.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct PsychometricPlot {
  struct Point {
    double level = 0;
    double share = 0;  ///< of right answers
    int trials = 0;    ///< the dot's area goes with them
  };
  struct CurvePoint {
    double level = 0;
    double share = 0;
  };
  struct Condition {
    std::string name;
    std::vector<Point> points;
    std::vector<CurvePoint> curve{};      ///< rising by level; empty: none
    std::optional<Interval> threshold{};  ///< over subjects
  };

  std::string title;
  std::string levelLabel = "Level";
  double guess = 0;  ///< a line across
  std::vector<Condition> conditions;
};

Figure psychometricFigure(const PsychometricPlot& plot);

}  // namespace ocelli
