// Errors of directions on circles, a condition each: 0 is at the top and degrees go clockwise, as on a compass. Sectors
// have areas in proportion to their shares (Fisher 1993, section 2.2); within the circle, whose radius is a resultant
// length of 1, stand the mean vectors of subjects and of all.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "oc_core/drawing/figure.h"

namespace ocelli {

struct RosePlot {
  struct Vector {
    double degrees = 0;
    double length = 0;  ///< 0 to 1
  };
  struct Condition {
    std::string name;
    std::vector<double> degrees;     ///< of trials; those that are not finite are left out
    std::vector<Vector> subjects{};  ///< their mean vectors
    std::optional<Vector> mean{};
    std::optional<std::pair<double, double>> interval{};  ///< of the mean direction, degrees
  };

  std::string title;
  std::vector<Condition> conditions;
};

inline constexpr double kRoseSectorDegrees = 15;

Figure roseFigure(const RosePlot& plot);

}  // namespace ocelli
