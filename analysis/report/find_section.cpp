#include "analysis/report/find_section.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/inference/accelerated_failure_time.h"
#include "analysis/inference/cox.h"
#include "analysis/inference/kaplan_meier.h"
#include "analysis/inference/log_rank.h"
#include "analysis/inference/restricted_mean_bootstrap.h"
#include "analysis/plot/group_plot.h"
#include "analysis/plot/survival_plot.h"
#include "analysis/report/navigation_section.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/planned_model.h"
#include "analysis/report/resampled_effects.h"
#include "analysis/report/search_times.h"
#include "analysis/report/sensitivity.h"
#include "analysis/report/time_model.h"

namespace ocelli {
namespace {

/// Rows that are fitted again without cases, at most.
constexpr size_t kMaxRows = 400000;

SurvivalPlot::Curve plotCurve(const std::string& name, const SurvivalCurve& curve,
                              const std::vector<double>& riskTimes) {
  SurvivalPlot::Curve result;
  result.name = name;
  for (const SurvivalStep& step : curve.steps) {
    result.steps.push_back({step.riskSet.seconds, step.survival, step.lower, step.upper});
    result.censoredTimes.insert(result.censoredTimes.end(), step.riskSet.censored, step.riskSet.seconds);
  }
  for (const double time : riskTimes) {
    const auto next = std::find_if(curve.steps.begin(), curve.steps.end(),
                                   [&](const SurvivalStep& step) { return step.riskSet.seconds >= time; });
    result.atRisk.push_back(next == curve.steps.end() ? 0 : next->riskSet.atRisk);
  }
  return result;
}

void addSurvival(ReportWork& work, const TrialList& trials, TimeoutTreatment timeouts) {
  const double limit = searchLimit(trials);
  SurvivalPlot plot;
  plot.title = "Searches that have not ended yet";
  plot.limit = limit;
  plot.widthMillimetres = kDoubleColumnMillimetres;
  for (int i = 0; i <= 6; ++i) {
    plot.riskTimes.push_back(limit * i / 6);
  }
  std::vector<EstimateRow> rows;
  for (const TrialView view : kViews) {
    const TrialList seen = trialsOfView(trials, view);
    const std::string source = fmt::format("Kaplan-Meier curve of {} with view {}", sizeText(seen), markOf(view));
    const Estimable<SurvivalCurve> curve =
        survivalCurve(timesOf(seen, timeouts), 0.95, numbered(subjectsOf(seen)), caseNumbers(seen));
    if (!curve) {
      addNotEstimable(work.document, fmt::format("Survival curve of {}", markOf(view)), curve.reason());
      continue;
    }
    if (!curve->noBands.empty()) {
      addNotEstimable(work.document, fmt::format("Bands of the survival curve of {}", markOf(view)), curve->noBands);
    }
    plot.curves.push_back(plotCurve(labelOf(work, view), *curve, plot.riskTimes));
    rows.push_back({fmt::format("{}: median time", markOf(view)), medianTime(*curve), "s", source, seen});
    const Estimable<RestrictedMean> mean =
        restrictedMean(timesOf(seen, timeouts), limit, numbered(subjectsOf(seen)), 0.95, caseNumbers(seen));
    rows.push_back({fmt::format("{}: restricted mean to {:g} s", markOf(view), limit),
                    mean ? Estimable<Estimate>(mean->mean) : Estimable<Estimate>::impossible(mean.reason()), "s",
                    source, seen});
  }
  if (!plot.curves.empty()) {
    addFigure(work,
              fmt::format("Kaplan-Meier curves of searches, {}; bands: 95 % at each time by itself, subjects and cases "
                          "as clusters, Student's t",
                          sizeText(trials)),
              "figure-find-survival", [&] { return survivalFigure(plot); });
  }
  const Estimable<RestrictedMeanDifference> difference = restrictedMeanDifferenceOf(trials, timeouts, limit);
  rows.push_back(
      {"@other@ less @reference@: difference of restricted means",
       difference ? Estimable<Estimate>(difference->difference) : Estimable<Estimate>::impossible(difference.reason()),
       "s", fmt::format("{}, subjects and cases as clusters", sizeText(trials)), trials});
  addEstimates(
      work.document,
      fmt::format("Times to find, time-outs {}; intervals of medians, means and their difference take subjects "
                  "and cases as clusters, with Student's t",
                  nameOf(timeouts)),
      "find-survival", rows);
  addResampled(work, "Difference of restricted means (@other@ less @reference@) by resampling subjects and cases",
               "find-survival-resampled",
               {{"@other@ less @reference@",
                 bootstrapRestrictedMeanDifference(timesOf(trials, timeouts), areOther(trials), limit,
                                                   numbered(subjectsOf(trials)), caseNumbers(trials),
                                                   bootstrapPlanOf(work.analysis.plan)),
                 trials, "s"}});
}

/// Whether the curves differ anywhere.
void addLogRank(ReportWork& work, const TrialList& trials, TimeoutTreatment timeouts) {
  std::vector<int> views;
  for (const Trial* trial : trials) {
    views.push_back(static_cast<int>(trial->view));
  }
  const Estimable<LogRankTest> test = logRankTest(timesOf(trials, timeouts), views, numbered(subjectsOf(trials)));
  if (!test) {
    addNotEstimable(work.document, "Log-rank test", test.reason());
    return;
  }
  const std::string source = fmt::format("log-rank test of {}, subjects as strata", sizeText(trials));
  std::vector<ValueRow> rows;
  for (const LogRankGroup& group : test->groups) {
    rows.push_back(
        {fmt::format("{}: found, expected if the views were alike", markOf(kViews[static_cast<size_t>(group.label)])),
         fmt::format("{:.0f}, {:.1f}", group.observed, group.expected), group.observed, source, trials});
  }
  const Estimate& chiSquared = test->chiSquared;
  rows.push_back({"Chi-squared with 1 degree of freedom", fixedText(chiSquared.statistic, 2), chiSquared.statistic,
                  source, trials});
  rows.push_back({"p", pValueText(chiSquared.pValue), chiSquared.pValue, source, trials});
  addValues(work.document,
            "Log-rank test of the curves: the searches of each subject are compared with each other, and taken as "
            "independent, also those for the same object",
            "find-survival-log-rank", rows);
}

/// Ratios of the covariates by name, of hazards or of times.
using NamedRatios = std::vector<std::pair<std::string, Estimable<Estimate>>>;

Estimable<Estimate> unlessOfOneCluster(const Estimate& ratio) {
  return std::isfinite(ratio.standardError)
             ? Estimable<Estimate>(ratio)
             : Estimable<Estimate>::impossible(
                   "it rests on one subject or one case alone, so that how far it varies is not known");
}

Estimable<NamedRatios> fitSurvival(const PlannedModel& model, const TrialList& trials, TimeoutTreatment timeouts) {
  using Result = Estimable<NamedRatios>;
  const SurvivalData data = survivalDataOf(model, trials, timeouts);
  if (data.covariates.empty()) {
    return Result::impossible("no term of it varies");
  }
  NamedRatios ratios;
  if (model.kind == ModelKind::kCox) {
    const Estimable<CoxFit> fit = fitCox(data);
    if (!fit) {
      return Result::impossible(fit.reason());
    }
    for (const CoxTerm& term : fit->terms) {
      ratios.emplace_back(term.name, unlessOfOneCluster(term.hazardRatio));
    }
  } else {
    const Estimable<FailureTimeFit> fit = fitLogNormal(data);
    if (!fit) {
      return Result::impossible(fit.reason());
    }
    for (const TimeRatioTerm& term : fit->terms) {
      ratios.emplace_back(term.name, unlessOfOneCluster(term.timeRatio));
    }
  }
  return ratios;
}

Estimable<Estimate> viewOf(const Estimable<NamedRatios>& ratios) {
  if (!ratios) {
    return Estimable<Estimate>::impossible(ratios.reason());
  }
  for (const auto& [name, ratio] : *ratios) {
    if (name.starts_with("view=") && name.find(':') == std::string::npos) {
      return ratio;
    }
  }
  return Estimable<Estimate>::impossible("the view does not vary, or is not in the model");
}

void addSurvivalSensitivity(ReportWork& work, const PlannedModel& model, const TrialList& all,
                            TimeoutTreatment timeouts) {
  const TrialList trials = timeouts == TimeoutTreatment::kRemoved ? withoutTimeouts(all) : all;
  std::vector<Variant> first{{fmt::format("Time-outs {}", labelOf(timeouts)), trials, timeouts}};
  for (const TimeoutTreatment other : kTimeoutTreatments) {
    if (other != timeouts) {
      first.push_back({fmt::format("Time-outs {}", labelOf(other)),
                       other == TimeoutTreatment::kRemoved ? withoutTimeouts(all) : all, other});
    }
  }
  const bool cox = model.kind == ModelKind::kCox;
  addSensitivity(work,
                 {fmt::format("{}-sensitivity", model.name),
                  fmt::format("The effect of the view in the {}, analysed in other ways", wordsOf(model, false)),
                  cox ? "Hazard ratio, @other@ / @reference@" : "Ratio of times, @other@ / @reference@",
                  cox ? "@reference@ sooner" : "@other@ faster", cox ? "@other@ sooner" : "@reference@ faster"},
                 variantsOf(trials, first, kMaxRows),
                 [&](const Variant& variant) { return viewOf(fitSurvival(model, variant.trials, variant.timeouts)); });
}

/// Cox or log-normal: as a table of ratios.
void addSurvivalModel(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& all) {
  const TimeoutTreatment timeouts = task.timeouts(work.analysis.plan);
  const TrialList complete = completeTrials(model, all);
  const TrialList trials = timeouts == TimeoutTreatment::kRemoved ? withoutTimeouts(complete) : complete;
  const std::string source = fmt::format("model {} of {}", model.name, sizeText(trials));
  const Estimable<NamedRatios> ratios = fitSurvival(model, trials, timeouts);
  if (!ratios) {
    addNotEstimable(work.document, wordsOf(model), ratios.reason());
    return;
  }
  std::vector<EstimateRow> rows;
  for (const auto& [name, ratio] : *ratios) {
    rows.push_back({name, ratio, "", source, trials});
    for (const std::string& term : model.terms) {
      if (columnOfTerm(model, trials, term) == name) {
        rows.back().label = labelOfTerm(term);
        if (ratio) {
          work.outcomes.push_back({model.name, term, ratio->pValue, TestedEffect{measureOfTerm(model, term), *ratio}});
        } else {
          work.outcomes.push_back({model.name, term, Estimable<double>::impossible(ratio.reason())});
        }
      }
    }
  }
  addEstimates(work.document,
               fmt::format("{}; {} as clusters, Student's t",
                           model.kind == ModelKind::kCox
                               ? "Cox regression: hazard ratios (above 1: found sooner) over all subjects and cases, "
                                 "which are nearer to 1 than those of one subject and case"
                               : "Log-normal failure times: ratios of times (below 1: found sooner)",
                           namesCases(model) ? "subjects and cases" : "subjects"),
               model.name, rows);
  addSurvivalSensitivity(work, model, complete, timeouts);
}

void addKaplanMeier(ReportWork& work, const ReportTask& task, const PlannedModel& /*model*/, const TrialList& trials) {
  const TimeoutTreatment timeouts = task.timeouts(work.analysis.plan);
  const TrialList kept = timeouts == TimeoutTreatment::kRemoved ? withoutTimeouts(trials) : trials;
  addSurvival(work, kept, timeouts);
  addLogRank(work, kept, timeouts);
}

void addCases(ReportWork& work, const TrialList& trials) {
  for (const bool moving : {false, true}) {
    std::map<int, std::array<std::vector<double>, 2>> cases;
    for (const Trial* trial : trials) {
      if (trial->moving.value_or(false) == moving) {
        cases[trial->caseIndex][trial->view == TrialView::kOther].push_back(*trial->responseSeconds);
      }
    }
    if (cases.empty()) {
      continue;
    }
    GroupPlot plot;
    plot.title = fmt::format("Times of each case, {} objects", moving ? "moving" : "stationary");
    plot.conditionLabel = "Case";
    plot.valueLabel = "Time to find (s)";
    plot.summaryName = "median, quartiles";
    plot.pointName = "one search";
    plot.rows = true;
    plot.widthMillimetres = kDoubleColumnMillimetres;
    plot.series = {{labelOf(work, TrialView::kReference), {}}, {labelOf(work, TrialView::kOther), {}}};
    for (auto& [index, views] : cases) {
      plot.conditions.push_back(std::to_string(index + 1));
      for (size_t v = 0; v < 2; ++v) {
        std::vector<double>& times = views[v];
        std::sort(times.begin(), times.end());
        const auto quantile = [&](double p) {
          return times.empty() ? kNotKnown : times[static_cast<size_t>(p * static_cast<double>(times.size() - 1))];
        };
        plot.series[v].groups.push_back({{quantile(0.5), quantile(0.25), quantile(0.75)}, times});
      }
    }
    addFigure(work, plot.title + "; time-outs stand at the limit",
              moving ? "figure-find-cases-moving" : "figure-find-cases", [&] { return groupFigure(plot); });
  }
}

void addFindSection(ReportWork& work, const ReportTask& task) {
  addHeading(work.document, 1, "Finding objects", task.name);
  TrialList trials = trialsOfTask(work.analysis, task.name);
  std::erase_if(trials, [](const Trial* trial) { return !trial->responseSeconds; });
  if (trials.empty()) {
    addNotEstimable(work.document, "Searches", "there are no trials of this task");
    return;
  }
  work.document.add(
      ReportParagraph{fmt::format("{}, of which {} ended by the limit. Time-outs are treated as {} says: {}.",
                                  sizeText(trials), std::count_if(trials.begin(), trials.end(), isCensored),
                                  planName(work.analysis.plan), nameOf(task.timeouts(work.analysis.plan)))});
  addTaskModels(work, task, trials);
  addPart(work, "Times of each case", [&] { addCases(work, trials); });
  work.methods.push_back(
      "Beside them stand Kaplan-Meier curves and restricted means, with errors of the infinitesimal jackknife by "
      "clusters "
      "of subjects and of cases (Cameron, Gelbach and Miller 2011), and regressions of survival, with jackknife errors "
      "by the same clusters (Lipsitz, Dear and Zhao 1994) and Student's t.");
}

}  // namespace

ReportTask findReportTask() {
  const std::vector<std::string> terms{"view", "session", "moving"};
  const std::vector<RandomEffect> clusters{{"subject"}, {"case"}};
  ReportTask task;
  task.name = "find";
  task.title = "Finding";
  task.trialsName = "searches";
  task.timesOutcome = task.rightOutcome = "times to find";
  task.timeName = "Time to find (s)";
  task.rightName = "Share found";
  task.isTimed = true;
  task.parts = {{"Finding objects", "searches", 0, addFindSection},
                {"Navigation", "navigation", 0.4, addNavigationSection}};
  task.modelKinds = {{ModelKind::kLogNormalMixed, addTimeModel},
                     {ModelKind::kLinearMixed, addTimeModel},
                     {ModelKind::kKaplanMeier, addKaplanMeier},
                     {ModelKind::kCox, addSurvivalModel},
                     {ModelKind::kLogNormalSurvival, addSurvivalModel}};
  task.models = {{"find-time",
                  "find",
                  ModelKind::kLogNormalMixed,
                  {"view", "session", "moving", "view:session", "view:moving"},
                  {{"subject", {"view"}}, {"case", {"view"}}}},
                 {"find-survival", "find", ModelKind::kKaplanMeier},
                 {"find-hazard", "find", ModelKind::kCox, terms, clusters},
                 {"find-log-normal", "find", ModelKind::kLogNormalSurvival, terms, clusters}};
  task.hypotheses = {
      {{"find-faster", "Objects are found in another time with the @other@ than with the @reference@", "find-time",
        "view"},
       true},
      {{"find-learning", "Sessions change the times of the two views differently", "find-time", "view:session"}}};
  return task;
}

}  // namespace ocelli
