// Estimates of lengths against the truth, a panel a condition with the same logarithmic axes: a dot a trial, the line
// where both are equal, and the power law of a model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/drawing/figure.h"

namespace ocelli {

struct EstimatePlot {
  struct Point {
    double truth = 0;
    double estimate = 0;
  };
  /// log estimate = logAtCenter + exponent (log truth - logCenter)
  struct Law {
    double exponent = 1;
    double logCenter = 0;
    double logAtCenter = 0;
  };
  struct Condition {
    std::string name;
    std::vector<Point> points;  ///< those that are not above 0 are left out
    std::optional<Law> law{};
  };

  std::string title;
  std::string unit;  ///< "metres"
  std::vector<Condition> conditions;
};

Figure estimateFigure(const EstimatePlot& plot);

}  // namespace ocelli
