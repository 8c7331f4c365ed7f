// Speed against accuracy: for each subject and condition the time of an answer to the right and the share of right
// answers upwards. What belongs to one subject is joined by faint lines, so that one sees whether who is slower is also
// more often right.
#pragma once

#include <string>
#include <vector>

#include "analysis/plot/panel.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct TradeOffPlot {
  /// Of one subject, or of all; not finite where it is not known.
  struct Point {
    double seconds = 0;
    double share = 0;  ///< 0 to 1
  };
  struct Condition {
    std::string name;
    std::vector<Point> subjects;  ///< in the same order in all conditions
    Point mean{};
  };

  std::string title;
  std::string timeLabel;   ///< with its unit
  std::string shareLabel;  ///< of right answers
  std::vector<Condition> conditions;
  double widthMillimetres = kSingleColumnMillimetres;
};

Figure tradeOffFigure(const TradeOffPlot& plot);

}  // namespace ocelli
