// Values by condition and view: raw points as swarms, and summaries with their intervals. One chart for
//   learning curves       conditions are sessions; connected, raw values linked subject by subject
//   accuracy              conditions are durations, duplicates ...; shares in percent, chance as the reference
//   times of each case    cases from top to bottom (Figure 7.5 of the dissertation, with its raw data)
//   strips of groups      one series; each condition has a style of its own
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/plot/panel.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct GroupValues {
  Interval summary{};       ///< NaN where it is not known
  std::vector<double> raw;  ///< where linked: by subject, NaN where there is none
};

struct GroupSeries {
  std::string name;
  std::vector<GroupValues> groups;  ///< one for each condition
};

struct GroupPlot {
  std::string title;
  std::string conditionLabel;  ///< of the axis of conditions; may be empty
  std::string valueLabel;      ///< with its unit
  std::vector<std::string> conditions;
  std::vector<GroupSeries> series;
  std::string summaryName = "mean, 95 % interval";
  std::string pointName = "one subject";
  AxisScale scale = AxisScale::kLinear;
  bool fromZero = true;    ///< of a linear scale
  bool percent = false;    ///< values are shares: 0 to 1
  bool rows = false;       ///< conditions from the top down, values to the right
  bool connected = false;  ///< summaries of a series, by lines
  bool linked = false;     ///< raw values of a subject, by faint lines
  bool styleByCondition = false;
  bool legend = true;               ///< or a figure_grid.h has it
  std::optional<double> reference;  ///< a line across: chance
  std::string referenceName;
  double widthMillimetres = kSingleColumnMillimetres;
  double heightMillimetres = 0;  ///< 0: as much as it takes
};

Figure groupFigure(const GroupPlot& plot);
std::vector<LegendEntry> groupLegend(const GroupPlot& plot);

}  // namespace ocelli
