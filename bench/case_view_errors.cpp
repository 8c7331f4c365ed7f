#include "bench/case_view_errors.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <stdexcept>

#include "analysis/report/report_task.h"
#include "analysis/report/right_answers.h"
#include "analysis/report/view_test.h"

namespace ocelli {
namespace {

/// What one study says.
struct StudyResult {
  std::optional<Estimate> estimate{};
  std::optional<double> oneSided{};
  bool warned = false;
};

/// In log seconds: 3.5 % of searches reach the limit where cases gain alike, 7 % with a deviation of 0.8.
SimulatedTruth searches() {
  SimulatedTruth truth;
  truth.average = 3;
  truth.ofSubjects = 0.25;
  truth.ofSubjectViews = 0.15;
  truth.ofItems = 0.35;
  truth.ofTrials = 0.45;
  truth.limitSeconds = 60;
  return truth;
}

SimulatedTruth answers(double average) {
  SimulatedTruth truth;
  truth.outcome = SimulatedOutcome::kAnswers;
  truth.average = average;
  truth.ofSubjects = 0.5;
  truth.ofSubjectViews = 0.2;
  truth.ofItems = 0.4;
  return truth;
}

const PlannedEquivalence& boundsOf(const AnalysisPlan& plan) {
  const PlannedEquivalence* bounds = equivalenceBoundsOf(plan, "path");
  if (bounds == nullptr) {
    throw std::logic_error("the default plan has no bounds of equivalence for paths");
  }
  return *bounds;
}

/// The effect of the view at which shares differ by the upper bound.
double effectAtBound(const std::vector<Trial>& trials, SimulatedTruth truth, double bound) {
  double low = 0;
  double high = 5;
  for (int i = 0; i < 30; ++i) {
    truth.effects["view"] = (low + high) / 2;
    (SimulatedStudy(trials, truth).shareDifference() < bound ? low : high) = truth.effects["view"];
  }
  return (low + high) / 2;
}

StudyResult resultOf(const AnalysisPlan& plan, const PlannedModel& model, std::vector<Trial> trials) {
  StudyResult result;
  if (model.kind == ModelKind::kEquivalence) {
    const PlannedEquivalence& bounds = boundsOf(plan);
    if (const auto test = shareEquivalence(listOf(trials), {bounds.lower, bounds.upper}, kAlpha)) {
      result.estimate = test->difference;
      result.estimate->pValue = test->pValue;
      result.oneSided = test->pBelowUpper;
    }
    return result;
  }
  if (&model == viewModelOf(plan, model.task)) {
    AnalysisData analysis;
    analysis.data.trials = std::move(trials);
    analysis.plan = plan;
    const ViewTest test = testOfView(analysis, model);
    result.warned = test.warned;
    if (test.view) {
      result.estimate = *test.view;
    }
    return result;
  }
  for (const ReportedTerm& term : analyseStudy(model, trials).terms) {
    if (term.name == "view" || term.name == "difference") {
      result.estimate = term.estimate;
    }
  }
  return result;
}

}  // namespace

ErrorDesign smallDesign() {
  return {"small", std::vector<int>(8, 1), true};
}

ErrorDesign designOf2010() {
  return {"2010", sessionsOf2010(), false};
}

std::vector<ErrorScenario> errorScenarios() {
  std::vector<ErrorScenario> scenarios;
  for (const ErrorDesign& design : {smallDesign(), designOf2010()}) {
    for (const char* model :
         {"find-time", "find-log-normal", "find-hazard", "find-survival", "path-equivalence", "count-right"}) {
      for (const double ofItemViews : {0.0, 0.2, 0.4, 0.8}) {
        scenarios.push_back({model, design, ofItemViews});
      }
    }
  }
  return scenarios;
}

SimulatedStudy studyOf(const ErrorScenario& scenario, const Protocol& protocol) {
  const AnalysisPlan plan = defaultPlan();
  const PlannedModel* model = plan.findModel(scenario.model);
  if (model == nullptr) {
    throw std::logic_error("the default plan has no model " + scenario.model);
  }
  std::vector<Trial> trials = plannedTrials(protocol, model->task, scenario.design.sessions);
  if (scenario.design.stationary) {
    std::erase_if(trials, [](const Trial& trial) { return trial.moving.value_or(false); });
  }
  SimulatedTruth truth = model->task == "find" ? searches() : answers(model->task == "count" ? 0.8 : 0.75);
  truth.ofItemViews = scenario.ofItemViews;
  if (model->kind == ModelKind::kEquivalence) {
    truth.effects["view"] = effectAtBound(trials, truth, boundsOf(plan).upper);
  }
  return {trials, truth};
}

ErrorRates errorRatesOf(const ErrorScenario& scenario, const Protocol& protocol, const CoverageRun& run) {
  const AnalysisPlan plan = defaultPlan();
  const PlannedModel& model = *plan.findModel(scenario.model);
  const SimulatedStudy study = studyOf(scenario, protocol);
  std::vector<StudyResult> results(static_cast<size_t>(run.studies));
  tbb::parallel_for(size_t{0}, results.size(), [&](size_t i) {
    RandomNumbers numbers(run.seed, i);
    results[i] = resultOf(plan, model, study.draw(numbers));
  });
  ErrorRates rates;
  double sum = 0;
  double squares = 0;
  double reported = 0;
  for (const StudyResult& result : results) {
    rates.warned += result.warned ? 1 : 0;
    if (!result.estimate || !std::isfinite(result.estimate->pValue)) {
      ++rates.impossible;
      continue;
    }
    ++rates.rejected.trials;
    rates.rejected.successes += result.estimate->pValue < kAlpha ? 1 : 0;
    if (result.oneSided) {
      ++rates.oneSided.trials;
      rates.oneSided.successes += *result.oneSided < kAlpha ? 1 : 0;
    }
    sum += result.estimate->value;
    squares += result.estimate->value * result.estimate->value;
    reported += result.estimate->standardError * result.estimate->standardError;
  }
  if (const double count = rates.rejected.trials; count > 0) {
    rates.deviation = std::sqrt(std::max(0.0, squares / count - sum / count * sum / count));
    rates.standardError = std::sqrt(reported / count);
  }
  return rates;
}

}  // namespace ocelli
