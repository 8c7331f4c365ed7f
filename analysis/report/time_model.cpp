#include "analysis/report/time_model.h"

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

/// How trials count whose time ran out, for a reader of the methods.
const char* methodOf(TimeoutTreatment treatment) {
  switch (treatment) {
    case TimeoutTreatment::kCensored:
      return "count as censored (restricted likelihood, Laplace's approximation)";
    case TimeoutTreatment::kSetToLimit:
      return "count as if they had ended then";
    case TimeoutTreatment::kRemoved:
      return "are left out";
  }
  return "";
}

void addMethod(ReportWork& work, const ReportTask& task, const PlannedModel& model, const PlannedFit& fit,
               TimeoutTreatment treatment) {
  work.methods.push_back(fmt::format(
      "Log {} were compared by the mixed model {} with Satterthwaite's degrees of freedom, in which {} that "
      "the limit ended {}; its random effects are {}.",
      task.timesOutcome, model.name, task.trialsName, methodOf(treatment), structureMethod(model, fit)));
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

void addTimeModel(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& trialsOfAll) {
  const TimeoutTreatment timeouts = task.timeouts(work.analysis.plan);
  TrialList all = trialsOfAll;
  std::erase_if(all, [](const Trial* trial) { return !trial->responseSeconds; });
  const TrialList timed = searchesOfMixedModel(model, all, TimeoutTreatment::kSetToLimit);
  const size_t atOnce = completeTrials(model, all).size() - timed.size();
  if (atOnce > 0) {
    work.document.add(
        ReportNote{NoteKind::kWarning, fmt::format("{} {} took 0 s, which has no logarithm: the {} leaves them out.",
                                                   atOnce, task.trialsName, wordsOf(model, false))});
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
        NoteKind::kNote,
        fmt::format("The {} knows no censored times: {} whose time ran out count with the limit here, and no "
                    "hypothesis of the plan rests on it.",
                    wordsOf(model, false), task.trialsName)});
  }
  addMethod(work, task, model, *fit, treatment);
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
