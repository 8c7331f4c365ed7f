// Contrasts of a plan as weights of the rows of a grid (condition_terms.h).
#pragma once

#include <string>
#include <vector>

#include "analysis/report/condition_terms.h"

namespace ocelli {

/// One a row of the grid; they sum to 0. Impossible where a condition or level is unknown, or where the cells that are
/// compared do not have the same levels of the other factors: the means of an incomplete crossing would compare these
/// too.
Estimable<std::vector<double>> weightsOf(const PlannedContrast& contrast, const ConditionTerms& terms);

/// Of the mean of a condition over its rows.
std::vector<double> weightsOfCondition(size_t condition, const ConditionTerms& terms);

/// Those of the plan; where it has none for the model, each condition with the first.
std::vector<PlannedContrast> contrastsOf(const AnalysisPlan& plan, const PlannedModel& model,
                                         const ViewConditions& conditions);

/// What is compared: "graph-low / pinhole-low", "camera (graph / pinhole)", "camera (graph / pinhole) x height (low /
/// high)", "weights 0.5 a + 0.5 b - c".
std::string comparisonText(const PlannedContrast& contrast);

}  // namespace ocelli
