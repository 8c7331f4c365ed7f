#include "analysis/report/right_model.h"

#include <fmt/format.h>

#include <numeric>

#include "analysis/report/effect_sizes.h"
#include "analysis/report/model_checks.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/planned_model.h"
#include "analysis/report/resampled_caution.h"
#include "analysis/report/resampled_effects.h"
#include "analysis/report/right_answers.h"
#include "analysis/report/sensitivity.h"

namespace ocelli {
namespace {

/// Rows that are fitted again without cases, at most: a fit takes some 100 microseconds a row, or three times that with
/// slopes. 45 subjects with 40 counts in three sessions are 152,000.
constexpr size_t kMaxRows = 160000;

void addRightSensitivity(ReportWork& work, const PlannedModel& model, const TrialList& trials) {
  std::vector<Variant> first{{"All trials", trials}};
  TrialList inTime = trials;
  std::erase_if(inTime, [](const Trial* trial) { return trial->censored.value_or(false); });
  if (inTime.size() < trials.size()) {
    first.push_back({"Without answers that did not come in time", inTime});
  }
  Variants variants = variantsOf(trials, first, kMaxRows);
  if (inTime.size() == trials.size()) {
    variants.notes.emplace_back(work.analysis.data.timeoutsAreKnown
                                    ? "All answers came in time: there are no time-outs to treat in another way."
                                    : "Which answers did not come in time is not known.");
  }
  variants.notes.emplace_back(kFittedModelNote);
  addSensitivity(work,
                 {fmt::format("{}-sensitivity", model.name),
                  fmt::format("The effect of the view in the {}, analysed in other ways", wordsOf(model, false)),
                  "Odds ratio, @other@ / @reference@", "@reference@ better", "@other@ better"},
                 variants, [&](const Variant& variant) { return viewRatio(fitBinomial(model, variant.trials)); });
}

}  // namespace

void addRightModel(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& all) {
  const TrialList trials = completeTrials(model, answeredTrials(all));
  const auto part = [&](const char* what, const std::function<void()>& add) {
    addPart(work, fmt::format("Model {}, {}", model.name, what), add);
  };
  Estimable<PlannedFit> fit = Estimable<PlannedFit>::impossible("it was not fitted");
  part("fit", [&] {
    fit = fitBinomial(model, trials);
    addPlannedFit(work, model, trials, fit,
                  fmt::format("Binomial mixed model of {}: odds ratios, variances by restricted likelihood, intervals "
                              "and tests by Satterthwaite's degrees of freedom",
                              task.rightOutcome));
  });
  if (fit) {
    part("checks", [&] { addBinomialChecks(work, model, trials, *fit); });
    work.methods.push_back(
        fmt::format("The random effects of the mixed model {} are {}.", model.name, structureMethod(model, *fit)));
  }
  std::vector<double> right;
  for (const Trial* trial : trials) {
    right.push_back(trial->correct.value_or(false) ? 1 : 0);
  }
  part("resampled", [&] {
    const Estimable<BootstrapResult> resampled =
        bootstrapViewDifference(trials, right, bootstrapPlanOf(work.analysis.plan));
    addResampled(work,
                 "Difference of shares of right answers (@other@ less @reference@) by resampling subjects and cases",
                 fmt::format("{}-resampled", model.name), {{"@other@ less @reference@", resampled, trials}});
    if (fit) {
      const double share = std::accumulate(right.begin(), right.end(), 0.0) / static_cast<double>(right.size());
      addResampledCaution(work, model, viewLogarithm(*fit), resampled, 1 / (share * (1 - share)));
    }
  });
  part("sizes of the effect", [&] { addShareEffects(work, trials, fmt::format("{}-sizes", model.name)); });
  if (fit) {
    part("other ways", [&] { addRightSensitivity(work, fittedModel(model, *fit), trials); });
  }
}

}  // namespace ocelli
