// What was measured of searches with a log, as tables: means of subjects, what the searches were like, what became of
// them, and what is not known.
#pragma once

#include <string>
#include <vector>

#include "analysis/measures/navigation.h"
#include "analysis/report/report_parts.h"
#include "analysis/report/subject_means.h"

namespace ocelli {

/// Searches for objects that stand, or that move.
struct NavigationGroup {
  bool moving = false;
  std::vector<const SearchNavigation*> searches{};
};

struct NavigationMeasure {
  std::string name;   ///< with its unit
  std::string panel;  ///< title in the figure; empty: it is not in there
  std::string axis;
  Estimable<double> (*of)(const SearchNavigation& search, const Trial& trial);
};

std::vector<NavigationMeasure> navigationMeasures();
/// Of the searches where it is known.
TrialValues valuesOf(const Dataset& data, const NavigationGroup& group, const NavigationMeasure& measure);

void addNavigationTables(ReportWork& work, const NavigationGroup& group);

}  // namespace ocelli
