// What measures of trials tell beside right answers and times, whatever the task is called: estimates, and thresholds
// of staircases. For any number of conditions.
#pragma once

#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/report/report_task.h"

namespace ocelli {

/// Tables and figures of the estimates and levels that the trials hold; nothing where they hold none.
void addMeasureSections(ReportWork& work, const ReportTask& task, const TrialList& trials);

/// How a condition is called in tables: of a pair by its mark, which becomes its label.
std::string conditionText(const ReportWork& work, TrialView view);

/// Each condition with the first, with p values corrected by Holm's method over these rows.
struct ConditionComparison {
  std::string label;
  Estimable<Estimate> effect;
  TrialList trials{};
};
/// Columns: what, estimate, 95 % interval, statistic, df, p, adjusted p. `source`: what was done.
void addComparisons(ReportWork& work, const std::string& caption, const std::string& id, const std::string& unit,
                    const std::string& source, const std::vector<ConditionComparison>& rows);

}  // namespace ocelli
