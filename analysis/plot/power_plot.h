// Power by the number of subjects, a curve for each effect, with intervals of the simulation.
#pragma once

#include <string>
#include <vector>

#include "analysis/plot/panel.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct PowerPlot {
  struct Point {
    double subjects = 0;
    Interval power{};
  };
  struct Curve {
    std::string name;  ///< "bent takes 0.8 of the time"
    std::vector<Point> points;
  };

  std::string title;
  std::string subjectsLabel = "Subjects";
  std::string powerLabel = "Power";
  std::vector<Curve> curves;
  double target = 0.8;  ///< a line across; where a curve passes it is said in the description
  double widthMillimetres = kSingleColumnMillimetres;
};

Figure powerFigure(const PowerPlot& plot);

}  // namespace ocelli
