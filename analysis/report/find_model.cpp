#include "analysis/report/find_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/effect_sizes.h"
#include "analysis/report/model_checks.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/planned_model.h"
#include "analysis/report/resampled_caution.h"
#include "analysis/report/resampled_effects.h"
#include "analysis/report/search_times.h"
#include "analysis/report/sensitivity.h"

namespace ocelli {
namespace {

/// Rows that are fitted again without cases, at most: linear models take some microseconds a row, those of censored
/// times some hundred.
constexpr size_t kMaxLinearRows = 2000000;
constexpr size_t kMaxCensoredRows = 160000;

/// How searches count whose time ran out, for a reader of the methods.
const char* methodOf(TimeoutTreatment treatment) {
  switch (treatment) {
    case TimeoutTreatment::kCensored:
      return "searches that the limit ended count as censored (restricted likelihood, Laplace's approximation)";
    case TimeoutTreatment::kSetToLimit:
      return "searches that the limit ended count as if they had ended then";
    case TimeoutTreatment::kRemoved:
      return "searches that the limit ended are left out";
  }
  return "";
}

void addMethod(ReportWork& work, const PlannedModel& model, const PlannedFit& fit, TimeoutTreatment treatment) {
  work.methods.push_back(
      fmt::format("Log times to find were compared by the mixed model {} with Satterthwaite's degrees of freedom, in "
                  "which {}; its random effects are {}.",
                  model.name, methodOf(treatment), structureMethod(model, fit)));
}

std::vector<bool> censoredOf(const TrialList& trials, TimeoutTreatment treatment) {
  std::vector<bool> censored;
  for (const Trial* trial : trials) {
    censored.push_back(treatment == TimeoutTreatment::kCensored && isCensored(trial));
  }
  return censored;
}

void addResampledView(ReportWork& work, const PlannedModel& model, const TrialList& trials, const PlannedFit& fit,
                      TimeoutTreatment treatment) {
  std::vector<double> logs;
  for (const double seconds : secondsOf(trials)) {
    logs.push_back(std::log(seconds));
  }
  const Estimable<BootstrapResult> resampled =
      bootstrapCensoredViewDifference(trials, logs, censoredOf(trials, treatment), bootstrapPlanOf(work.analysis.plan));
  addResampled(
      work,
      fmt::format("Ratio of geometric means (@other@ / @reference@) by resampling subjects and cases, time-outs {}",
                  labelOf(treatment)),
      fmt::format("{}-resampled", model.name), {{"@other@ / @reference@", resampled, trials, "", true}});
  addResampledCaution(work, model, viewLogarithm(fit), resampled, 1);
}

void addViewSensitivity(ReportWork& work, const PlannedModel& model, const TrialList& all, TimeoutTreatment main) {
  std::vector<Variant> first;
  const auto add = [&](TimeoutTreatment treatment) {
    first.push_back(
        {fmt::format("Time-outs {}", labelOf(treatment)), searchesOfMixedModel(model, all, treatment), treatment});
  };
  add(main);
  for (const TimeoutTreatment other : kTimeoutTreatments) {
    if (other != main && timesTreatmentOf(model, other) == other) {
      add(other);
    }
  }
  Variants variants =
      variantsOf(first.front().trials, first, main == TimeoutTreatment::kCensored ? kMaxCensoredRows : kMaxLinearRows);
  variants.notes.emplace_back(kFittedModelNote);
  addSensitivity(work,
                 {fmt::format("{}-sensitivity", model.name), "The effect of the view on times, analysed in other ways",
                  "Ratio of geometric means, @other@ / @reference@", "@other@ faster", "@reference@ faster"},
                 variants,
                 [&](const Variant& variant) { return viewRatio(fitTimes(model, variant.trials, variant.timeouts)); });
}

}  // namespace

void addFindModel(ReportWork& work, const PlannedModel& model, const TrialList& all, TimeoutTreatment timeouts) {
  const TrialList timed = searchesOfMixedModel(model, all, TimeoutTreatment::kSetToLimit);
  const size_t atOnce = completeTrials(model, all).size() - timed.size();
  if (atOnce > 0) {
    work.document.add(ReportNote{
        NoteKind::kWarning, fmt::format("{} searches took 0 s, which has no logarithm: the {} leaves them out.", atOnce,
                                        wordsOf(model, false))});
  }
  const TimeoutTreatment treatment = timesTreatmentOf(model, timeouts);
  const TrialList trials = searchesOfMixedModel(model, all, treatment);
  const Estimable<PlannedFit> fit = fitTimes(model, trials, treatment);
  addPlannedFit(work, model, trials, fit,
                fmt::format("Mixed model of the logarithm of times, time-outs {}: ratios of geometric means, intervals "
                            "and tests by Satterthwaite's degrees of freedom",
                            labelOf(treatment)));
  if (!fit) {
    return;
  }
  if (treatment != timeouts) {
    work.document.add(ReportNote{
        NoteKind::kNote, fmt::format("The {} knows no censored times: searches whose time ran out count with the limit "
                                     "here, and no hypothesis of the plan rests on it.",
                                     wordsOf(model, false))});
  }
  addMethod(work, model, *fit, treatment);
  const auto part = [&](const char* what, const std::function<void()>& add) {
    addPart(work, fmt::format("Model {}, {}", model.name, what), add);
  };
  part("checks", [&] { addLinearChecks(work, model, *fit); });
  part("resampled", [&] { addResampledView(work, model, trials, *fit, treatment); });
  part("sizes of the effect",
       [&] { addTimeEffects(work, trials, secondsOf(trials), fmt::format("{}-sizes", model.name)); });
  part("other ways", [&] { addViewSensitivity(work, fittedModel(model, *fit), all, treatment); });
}

}  // namespace ocelli
