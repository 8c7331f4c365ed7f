#include "analysis/report/share_models.h"

#include <fmt/format.h>

#include "analysis/inference/bayes_factor.h"
#include "analysis/inference/equivalence.h"
#include "analysis/report/report_parts.h"
#include "analysis/report/right_answers.h"
#include "analysis/report/view_test.h"

namespace ocelli {
namespace {

ValueRow withInterval(ValueRow row, const Interval& interval) {
  row.interval = interval;
  return row;
}

}  // namespace

void addEquivalenceModel(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& all) {
  const TrialList trials = answeredTrials(all);
  const PlannedEquivalence* planned = equivalenceBoundsOf(work.analysis.plan, task.name);
  const Estimable<EquivalenceTest> test =
      planned == nullptr
          ? Estimable<EquivalenceTest>::impossible(fmt::format("the plan has no bounds for {}", task.trialsName))
          : shareEquivalence(trials, {planned->lower, planned->upper}, work.analysis.plan.alpha);
  if (!test) {
    work.outcomes.push_back({model.name, "", Estimable<double>::impossible(test.reason())});
    addNotEstimable(work.document, "Equivalence of the views", test.reason());
    return;
  }
  work.outcomes.push_back(
      {model.name, "", test->pValue,
       TestedEffect{fmt::format("difference of shares of {}, @other@ less @reference@", task.rightOutcome),
                    test->difference, 1 - 2 * test->alpha}});
  const std::string source =
      fmt::format("{} subjects with both views, one difference each; subjects and cases as clusters", test->first);
  const auto row = [&](const std::string& what, const std::string& text, std::optional<double> value) {
    return ValueRow{what, text, value, source, trials};
  };
  addValues(
      work.document,
      fmt::format("Two one-sided tests against the bounds of {}, {} to {} (@other@ less @reference@): mean of the "
                  "subjects' differences, subjects and cases as clusters",
                  planName(work.analysis.plan), planned->lower, planned->upper),
      model.name,
      {row("Difference of shares", numberText(test->difference.value), test->difference.value),
       withInterval(row(fmt::format("{:g} % interval", 100 * (1 - 2 * test->alpha)),
                        fmt::format("{} to {}", numberText(test->difference.lower), numberText(test->difference.upper)),
                        std::nullopt),
                    intervalOf(test->difference)),
       row(kEquivalenceTestRow, numberText(test->pValue), test->pValue),
       row("Equivalent", test->equivalent ? "yes" : "not shown", std::nullopt)});
}

void addBayesModel(ReportWork& work, const ReportTask& /*task*/, const PlannedModel& model, const TrialList& all) {
  const TrialList trials = answeredTrials(all);
  const Estimable<Estimate> difference = shareDifference(trials);
  const Estimable<BayesFactor> factor =
      difference ? bayesFactorOfEstimate(*difference) : Estimable<BayesFactor>::impossible(difference.reason());
  if (!factor) {
    addNotEstimable(work.document, "Bayes factor", factor.reason());
    return;
  }
  const std::string source = fmt::format("t of {:.3g} with {:g} degrees of freedom, of {}", difference->statistic,
                                         difference->degreesOfFreedom, sizeText(trials));
  addValues(
      work.document,
      "Bayes factor of the difference of shares (Jeffreys-Zellner-Siow, medium scale) from its t with subjects and "
      "cases as clusters: for other subjects and other cases of their kind",
      model.name,
      {{"For none, against some", numberText(factor->forNone), factor->forNone, source, trials},
       {"For some, against none", numberText(factor->forEffect), factor->forEffect, source, trials}});
}

}  // namespace ocelli
