#include "analysis/report/measure_sections.h"

#include <fmt/format.h>

#include "analysis/inference/holm.h"
#include "analysis/report/estimate_section.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/threshold_section.h"

namespace ocelli {

std::string conditionText(const ReportWork& work, TrialView view) {
  const ViewConditions& conditions = work.analysis.data.conditions;
  return conditions.isPair() ? markOf(view) : conditions.nameOf(view);
}

void addComparisons(ReportWork& work, const std::string& caption, const std::string& id, const std::string& unit,
                    const std::string& source, const std::vector<ConditionComparison>& rows) {
  std::vector<EstimateRow> estimates;
  std::vector<double> pValues;
  for (const ConditionComparison& row : rows) {
    estimates.push_back({row.label, row.effect, unit, source, row.trials});
    pValues.push_back(row.effect ? row.effect->pValue : kNotKnown);
  }
  if (rows.empty()) {
    return;
  }
  addEstimates(work.document, caption, id, estimates);
  if (rows.size() < 2) {
    return;
  }
  const std::vector<double> adjusted = holmAdjusted(pValues);
  std::vector<ValueRow> corrected;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].effect) {
      corrected.push_back({rows[i].label, pValueText(adjusted[i]), adjusted[i],
                           fmt::format("p value by Holm's method over {} comparisons", rows.size()), rows[i].trials});
    }
  }
  if (!corrected.empty()) {
    addValues(work.document, fmt::format("{}: p values corrected by Holm's method over these rows", caption),
              fmt::format("{}-holm", id), corrected);
  }
}

void addMeasureSections(ReportWork& work, const ReportTask& task, const TrialList& trials) {
  const TaskMeasures measures = taskMeasures(trials);
  if (measures.estimates) {
    addPart(work, fmt::format("Estimates of {}", task.name), [&] { addEstimateSection(work, task, trials); });
  }
  if (measures.levels) {
    addPart(work, fmt::format("Thresholds of {}", task.name), [&] { addThresholdSection(work, task, trials); });
  }
}

}  // namespace ocelli
