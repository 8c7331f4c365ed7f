#include "analysis/report/estimate_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/plot/estimate_plot.h"
#include "analysis/plot/group_plot.h"
#include "analysis/report/direction_section.h"
#include "analysis/report/estimate_trials.h"
#include "analysis/report/measure_sections.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/power_law.h"
#include "analysis/report/subject_means.h"

namespace ocelli {
namespace {

/// Of logarithms of ratios: 0.1 is 10.5 %.
Estimate asPercent(Estimate logarithm) {
  logarithm.standardError = 100 * std::exp(logarithm.value) * logarithm.standardError;
  logarithm.value = 100 * std::expm1(logarithm.value);
  logarithm.lower = 100 * std::expm1(logarithm.lower);
  logarithm.upper = 100 * std::expm1(logarithm.upper);
  return logarithm;
}

/// How many trials of each condition have an estimate, and why others have none.
void addEstimateCounts(ReportWork& work, const std::string& id, const TrialList& trials,
                       const EstimateTrials& estimates) {
  ReportTable table{
      "Trials with an estimate; an answer that did not come in time is a missing estimate, and in no number "
      "below",
      fmt::format("{}-counts", id),
      {{"Condition", "", true}, {"Trials"}, {"Estimates"}, {"Time-outs"}, {"Missing otherwise"}},
      {}};
  table.isRecord = true;
  for (const TrialView view : work.analysis.data.conditions.all()) {
    const TrialList missing = trialsOfView(estimates.missing, view);
    const auto timedOut = static_cast<size_t>(std::count_if(
        missing.begin(), missing.end(), [](const Trial* trial) { return trial->censored.value_or(false); }));
    const auto count = [](size_t number) {
      ReportCell cell{std::to_string(number)};
      cell.value = static_cast<double>(number);
      return cell;
    };
    table.rows.push_back({ReportCell{conditionText(work, view)}, count(trialsOfView(trials, view).size()),
                          count(trialsOfView(estimates.trials, view).size()), count(timedOut),
                          count(missing.size() - timedOut)});
  }
  work.document.add(std::move(table));
}

struct ErrorTable {
  std::string title;  ///< "Bias of estimates"
  std::string id;
  std::string axis;  ///< of the figure, with its unit
  std::string what;  ///< "mean logarithms of estimate / truth"
  std::string unit{};
  bool tested = false;  ///< against no error
  bool fromZero = false;
  std::optional<double> reference{};
  std::function<Estimate(const Estimate&)> shown;
};

/// A table with a row a condition, and a figure with a dot a subject.
void addErrorTable(ReportWork& work, const ErrorTable& about, const TrialValues& errors) {
  std::vector<EstimateRow> rows;
  GroupPlot plot;
  plot.title = about.title;
  plot.valueLabel = about.axis;
  plot.rows = true;
  plot.legend = false;
  plot.fromZero = about.fromZero;
  plot.reference = about.reference;
  plot.referenceName = "no error";
  plot.series = {{"Conditions", {}}};
  for (const TrialView view : work.analysis.data.conditions.all()) {
    const SubjectNumbers means = subjectMeans(valuesOfView(errors, view));
    EstimateRow row = rowOfSubjects(conditionText(work, view), means, ValueScale::kPlain, about.what);
    row.unit = about.unit;
    if (row.estimate) {
      row.estimate = about.shown(*row.estimate);
    }
    GroupValues group = groupOfSubjects(means, ValueScale::kPlain);
    const auto shownValue = [&](double value) {
      Estimate estimate;
      estimate.value = value;
      return about.shown(estimate).value;
    };
    for (double& value : group.raw) {
      value = shownValue(value);
    }
    group.summary = {shownValue(group.summary.value), shownValue(group.summary.lower), shownValue(group.summary.upper)};
    rows.push_back(about.tested ? row : untested(row));
    if (!means.bySubject.empty()) {
      plot.conditions.push_back(labelOf(work, view));
      plot.series[0].groups.push_back(group);
    }
  }
  addEstimates(work.document,
               fmt::format("{} by condition: {} over subjects, with 95 % intervals{}", about.title, about.what,
                           about.tested ? "; tests are against no bias, and not corrected" : ""),
               about.id, rows);
  if (!plot.conditions.empty()) {
    addFigure(work, fmt::format("{} by condition: one dot a subject", about.title), fmt::format("figure-{}", about.id),
              [&] { return groupFigure(plot); });
  }
}

void addLengthErrors(ReportWork& work, const std::string& id, const EstimateTrials& estimates) {
  addErrorTable(work,
                {"Bias of estimates", fmt::format("{}-bias", id), "Estimate / truth (geometric mean)",
                 "mean logarithms of estimate / truth", "", true, false, 1.0,
                 [](const Estimate& estimate) { return exponentiated(estimate); }},
                estimates.signedErrors());
  addErrorTable(
      work,
      {"Absolute error of estimates", fmt::format("{}-absolute", id), "Absolute error (%)",
       "mean absolute logarithms of estimate / truth, as the percentage by which the larger of the two is above "
       "the other",
       "%", false, true, std::nullopt, asPercent},
      estimates.absoluteErrors());
}

void addDirectionErrors(ReportWork& work, const std::string& id, const EstimateTrials& estimates) {
  const auto asItIs = [](const Estimate& estimate) { return estimate; };
  addErrorTable(work,
                {"Signed error of directions", fmt::format("{}-bias", id), "Signed error (degrees)",
                 "mean signed errors (clockwise above 0)", "degrees", true, false, 0.0, asItIs},
                estimates.signedErrors());
  addErrorTable(work,
                {"Absolute error of directions", fmt::format("{}-absolute", id), "Absolute error (degrees)",
                 "mean absolute errors (guessing gives 90)", "degrees", false, true, std::nullopt, asItIs},
                estimates.absoluteErrors());
}

void addScatter(ReportWork& work, const std::string& id, const EstimateTrials& estimates,
                const Estimable<PowerLawFit>& law) {
  EstimatePlot plot;
  plot.title = "Estimates against the truth";
  plot.unit = estimates.unit->words;
  for (const TrialView view : work.analysis.data.conditions.all()) {
    EstimatePlot::Condition condition{labelOf(work, view), {}, std::nullopt};
    for (size_t i = 0; i < estimates.trials.size(); ++i) {
      if (estimates.trials[i]->view == view) {
        condition.points.push_back({estimates.values[i].truth, estimates.values[i].estimate});
      }
    }
    if (law) {
      const PowerLaw& ofView = law->conditions[indexOfCondition(view)];
      if (ofView.exponent && ofView.logAtCenter) {
        condition.law = EstimatePlot::Law{ofView.exponent->value, law->logCenter, ofView.logAtCenter->value};
      }
    }
    plot.conditions.push_back(std::move(condition));
  }
  addFigure(work,
            fmt::format("Estimates against the truth ({}): one dot a trial, dashed where they are equal{}", plot.unit,
                        law ? ", and the power law of the mixed model" : ""),
            fmt::format("figure-{}-scatter", id), [&] { return estimateFigure(plot); });
}

/// Exponents of the power law by condition, and how they differ.
void addPowerLaw(ReportWork& work, const std::string& id, const Estimable<PowerLawFit>& law) {
  if (!law) {
    addNotEstimable(work.document, "Power law of estimates", law.reason());
    return;
  }
  const std::vector<TrialView> views = work.analysis.data.conditions.all();
  std::vector<EstimateRow> exponents;
  std::vector<ConditionComparison> differences;
  for (size_t i = 0; i < views.size(); ++i) {
    const std::string condition = conditionText(work, views[i]);
    exponents.push_back(untested(
        {condition, law->conditions[i].exponent, "",
         fmt::format("slope of log estimate over log truth, mixed model of {}", sizeText(law->trials)), law->trials}));
    if (i > 0) {
      differences.push_back({fmt::format("{} less {}", condition, conditionText(work, views[0])),
                             law->conditions[i].difference, law->trials});
    }
  }
  addEstimates(work.document,
               "Exponent of the power law by condition: below 1, large distances are compressed against small ones",
               fmt::format("{}-exponents", id), exponents);
  addComparisons(work, "Differences of exponents", fmt::format("{}-exponent-differences", id), "",
                 "difference of slopes, mixed model with Satterthwaite's degrees of freedom", differences);
  work.document.add(ReportParagraph{fmt::format(
      "The model of log estimate has an intercept and a slope of log truth for each condition; random effects: {}.",
      law->structure)});
  for (const std::string& warning : law->warnings) {
    work.document.add(ReportNote{NoteKind::kWarning, fmt::format("Power law of estimates: {}.", warning)});
  }
}

}  // namespace

void addEstimateSection(ReportWork& work, const ReportTask& task, const TrialList& trials) {
  const EstimateTrials estimates = estimatesIn(trials);
  const std::string id = fmt::format("estimates-{}", namePart(task.name));
  addHeading(work.document, 2, fmt::format("Estimates of {} ({})", task.name, estimates.unit->words), id);
  addEstimateCounts(work, id, trials, estimates);
  if (estimates.unit->isDirection) {
    addDirectionErrors(work, id, estimates);
    addDirectionSection(work, id, estimates);
    return;
  }
  addLengthErrors(work, id, estimates);
  const Estimable<PowerLawFit> law = fitPowerLaw(work.analysis.data.conditions, estimates);
  addPart(work, "Power law of estimates", [&] { addPowerLaw(work, id, law); });
  addScatter(work, id, estimates, law);
}

}  // namespace ocelli
