// Kaplan-Meier curves: steps with bands, marks where trials were censored, and below the axis how many were still at
// risk.
#pragma once

#include <string>
#include <vector>

#include "analysis/plot/panel.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct SurvivalPlot {
  struct Step {
    double time = 0;
    double survival = 1;  ///< from this time on
    double lower = 1;     ///< NaN where there is no interval
    double upper = 1;
  };
  struct Curve {
    std::string name;
    std::vector<Step> steps;  ///< times rising; before the first the survival is 1
    std::vector<double> censoredTimes;
    std::vector<size_t> atRisk;  ///< at each of `riskTimes`
  };

  std::string title;
  std::string timeLabel = "Time (s)";
  std::string survivalLabel = "Not yet found";
  std::vector<Curve> curves;
  std::vector<double> riskTimes;  ///< none: the axis' own ticks have no table
  double limit = 60;              ///< the axis ends there
  double widthMillimetres = kSingleColumnMillimetres;
};

Figure survivalFigure(const SurvivalPlot& plot);

}  // namespace ocelli
