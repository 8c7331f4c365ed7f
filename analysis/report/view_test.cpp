#include "analysis/report/view_test.h"

#include <algorithm>

#include "analysis/report/condition_model.h"
#include "analysis/report/error_model.h"
#include "analysis/report/planned_model.h"
#include "analysis/report/report_task.h"
#include "analysis/report/right_answers.h"

namespace ocelli {
namespace {

constexpr const char* kView = "view";

}  // namespace

const PlannedModel* viewModelOf(const AnalysisPlan& plan, const std::string& taskName, std::optional<ModelKind> kind) {
  const ReportTask task = reportTask(taskName);
  const auto found = std::find_if(plan.models.begin(), plan.models.end(), [&](const PlannedModel& model) {
    return model.task == task.name && (!kind || model.kind == *kind) && isMixed(model.kind) &&
           task.findModelKind(model.kind) != nullptr &&
           std::find(model.terms.begin(), model.terms.end(), kView) != model.terms.end();
  });
  return found == plan.models.end() ? nullptr : &*found;
}

ViewTest testOfView(const AnalysisData& analysis, const PlannedModel& model) {
  Estimable<PlannedFit> fit = Estimable<PlannedFit>::impossible("");
  if (modelOutcomeOf(model.kind) == ModelOutcome::kEstimates) {
    fit = fitErrors(model, trialsOfErrorModel(model, trialsOfTask(analysis, model.task)));
  } else if (model.kind != ModelKind::kBinomialMixed) {
    const TimeoutTreatment timeouts = reportTask(model.task).timeouts(analysis.plan);
    fit = fitTimes(model, searchesOfMixedModel(model, trialsOfTask(analysis, model.task), timeouts), timeouts);
  } else {
    fit = fitBinomial(model, completeTrials(model, answeredTrials(trialsOfTask(analysis, model.task))));
  }
  const Estimable<Estimate> view = fit ? viewLogarithm(*fit) : Estimable<Estimate>::impossible(fit.reason());
  return {view ? view : Estimable<Estimate>::impossible(withViewNames(view.reason(), analysis.data.conditions)),
          fit && !fit->warnings.empty()};
}

ViewTest testOfContrast(const AnalysisData& analysis, const PlannedModel& model, const PlannedContrast& contrast) {
  const Estimable<ConditionFit> fit = fitConditions(analysis.data, model, trialsOfTask(analysis, model.task),
                                                    reportTask(model.task).timeouts(analysis.plan), {contrast});
  return {fit ? fit->contrasts.front().estimate : Estimable<Estimate>::impossible(fit.reason()), fit && fit->warned()};
}

const PlannedEquivalence* equivalenceBoundsOf(const AnalysisPlan& plan, const std::string& task) {
  const auto found = std::find_if(plan.equivalence.begin(), plan.equivalence.end(),
                                  [&](const PlannedEquivalence& bounds) { return bounds.task == task; });
  return found == plan.equivalence.end() ? nullptr : &*found;
}

Estimable<EquivalenceTest> testOfEquivalence(const AnalysisData& analysis, const PlannedEquivalence& bounds,
                                             double alpha) {
  return shareEquivalence(answeredTrials(trialsOfTask(analysis, bounds.task)), {bounds.lower, bounds.upper}, alpha);
}

}  // namespace ocelli
