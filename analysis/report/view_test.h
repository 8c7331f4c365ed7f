// Whether the views differ, as one study's report says it by the models of its plan: what simulations of power repeat.
#pragma once

#include <optional>
#include <string>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/dataset/exclusions.h"
#include "analysis/inference/equivalence.h"

namespace ocelli {

/// The plan's first mixed model of the task that has the term "view", of a kind that is done for the task. nullptr
/// where there is none. `kind`: or the first one of that kind.
const PlannedModel* viewModelOf(const AnalysisPlan& plan, const std::string& task,
                                std::optional<ModelKind> kind = std::nullopt);

struct ViewTest {
  Estimable<Estimate> view;  ///< other less reference, in log seconds, logits, or terms of errors
  bool warned = false;       ///< the fit is singular, did not converge, or lacks a column
};

/// `model` is one that viewModelOf() gives for the plan of these data.
ViewTest testOfView(const AnalysisData& analysis, const PlannedModel& model);

/// The contrast, likewise, in a study of any number of conditions.
ViewTest testOfContrast(const AnalysisData& analysis, const PlannedModel& model, const PlannedContrast& contrast);

/// The bounds that the plan has for the task; nullptr where it has none.
const PlannedEquivalence* equivalenceBoundsOf(const AnalysisPlan& plan, const std::string& task);
/// Of the mean of the subjects' differences of shares of right answers, against these bounds.
Estimable<EquivalenceTest> testOfEquivalence(const AnalysisData& analysis, const PlannedEquivalence& bounds,
                                             double alpha);

}  // namespace ocelli
