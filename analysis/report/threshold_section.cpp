#include "analysis/report/threshold_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/student.h"
#include "analysis/plot/group_plot.h"
#include "analysis/plot/psychometric_plot.h"
#include "analysis/report/measure_sections.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/threshold_trials.h"

namespace ocelli {
namespace {

constexpr size_t kMaxDrawnLevels = 24;
constexpr int kBins = 16;
constexpr int kCurveSteps = 80;

using Conditions = std::vector<ConditionThresholds>;

/// How many subjects have a threshold, and why others have none.
void addThresholdCounts(ReportWork& work, const std::string& id, const Conditions& conditions) {
  ReportTable table{"Subjects with a threshold; those beyond the levels that a subject met are in no number below",
                    fmt::format("{}-counts", id),
                    {{"Condition", "", true},
                     {"Trials"},
                     {"Time-outs"},
                     {"Subjects"},
                     {"Thresholds"},
                     {"Beyond the levels"},
                     {"Without"},
                     {"Separable"}},
                    {}};
  table.isRecord = true;
  ReasonNotes reasons;
  for (const TrialView view : work.analysis.data.conditions.all()) {
    const ConditionThresholds& condition = conditions[indexOfCondition(view)];
    int outside = 0;
    int without = 0;
    int separable = 0;
    for (const auto& [subject, threshold] : condition.bySubject) {
      outside += threshold.fit && threshold.fit->outside ? 1 : 0;
      separable += threshold.fit && threshold.fit->separable ? 1 : 0;
      if (!threshold.fit) {
        ++without;
        reasons.add(fmt::format("threshold of {}, {}", subject, conditionText(work, view)), threshold.fit.reason());
      }
    }
    const auto count = [](size_t number) {
      ReportCell cell{std::to_string(number)};
      cell.value = static_cast<double>(number);
      return cell;
    };
    const size_t subjects = condition.bySubject.size();
    table.rows.push_back({ReportCell{conditionText(work, view)}, count(condition.trials.size()),
                          count(static_cast<size_t>(condition.timeouts)), count(subjects),
                          count(subjects - static_cast<size_t>(outside + without)), count(static_cast<size_t>(outside)),
                          count(static_cast<size_t>(without)), count(static_cast<size_t>(separable))});
  }
  work.document.add(std::move(table));
  work.document.add(ReportNote{
      NoteKind::kNote,
      "Separable: all wrong answers of a subject lie below all right ones, so that the slope is what the prior says, "
      "and "
      "the threshold lies somewhere between them. Time-outs count as wrong answers, as the staircase had them."});
  reasons.write(work.document);
}

void addThresholdTables(ReportWork& work, const std::string& id, const Conditions& conditions) {
  std::vector<EstimateRow> means;
  std::vector<ConditionComparison> ratios;
  const std::vector<TrialView> views = work.analysis.data.conditions.all();
  const SubjectNumbers first = logThresholds(conditions.front());
  for (size_t i = 0; i < views.size(); ++i) {
    const SubjectNumbers numbers = logThresholds(conditions[i]);
    means.push_back(
        untested(rowOfSubjects(conditionText(work, views[i]), numbers, ValueScale::kLogarithm, "log thresholds")));
    if (i > 0) {
      const SubjectNumbers differences = subjectDifferences(first, numbers);
      const Estimable<Estimate> ratio = studentMean(numbersOf(differences));
      ratios.push_back({fmt::format("{} / {}", conditionText(work, views[i]), conditionText(work, views[0])),
                        ratio ? Estimable<Estimate>(exponentiated(*ratio)) : ratio, differences.trials});
    }
  }
  addEstimates(work.document,
               "Thresholds by condition: geometric means over subjects, with 95 % intervals; a lower one is better",
               fmt::format("{}-means", id), means);
  addComparisons(work, "Ratios of thresholds, within subjects", fmt::format("{}-ratios", id), "",
                 "mean difference of log thresholds of subjects with both conditions, Student's interval", ratios);
}

/// Shares of all subjects by level; of many levels, by bins of equal width in logarithms.
std::vector<PsychometricPlot::Point> sharesOf(const ConditionThresholds& condition) {
  std::map<double, std::pair<int, int>> byLevel;  // right, trials
  for (const auto& [subject, threshold] : condition.bySubject) {
    for (const LevelCounts& counts : threshold.counts) {
      byLevel[counts.logLevel].first += counts.right;
      byLevel[counts.logLevel].second += counts.trials;
    }
  }
  if (byLevel.size() > kMaxDrawnLevels) {
    const double low = byLevel.begin()->first;
    const double width = (byLevel.rbegin()->first - low) / kBins;
    std::map<double, std::pair<int, int>> binned;
    for (const auto& [level, counts] : byLevel) {
      const double bin = std::min(std::floor((level - low) / width), kBins - 1.0);
      auto& [right, trials] = binned[low + (bin + 0.5) * width];
      right += counts.first;
      trials += counts.second;
    }
    byLevel = std::move(binned);
  }
  std::vector<PsychometricPlot::Point> points;
  for (const auto& [level, counts] : byLevel) {
    points.push_back({std::exp(level), counts.first / static_cast<double>(counts.second), counts.second});
  }
  return points;
}

/// The mean of the curves of subjects: what shares of all of them follow.
std::vector<PsychometricPlot::CurvePoint> curveOf(const ConditionThresholds& condition,
                                                  const std::vector<PsychometricPlot::Point>& points) {
  std::vector<PsychometricPlot::CurvePoint> curve;
  if (points.size() < 2) {
    return curve;
  }
  PsychometricModel model;
  model.guess = condition.guess;
  const double low = std::log(points.front().level);
  const double high = std::log(points.back().level);
  for (int i = 0; i <= kCurveSteps; ++i) {
    const double level = low + (high - low) * i / kCurveSteps;
    double sum = 0;
    int fits = 0;
    for (const auto& [subject, threshold] : condition.bySubject) {
      if (threshold.fit) {
        sum += rightProbability(model, threshold.fit->point, level);
        ++fits;
      }
    }
    if (fits > 0) {
      curve.push_back({std::exp(level), sum / fits});
    }
  }
  return curve;
}

void addThresholdFigures(ReportWork& work, const std::string& id, const Conditions& conditions) {
  PsychometricPlot plot;
  plot.title = "Right answers by level";
  GroupPlot group;
  group.title = "Thresholds by condition";
  group.valueLabel = "Threshold (level)";
  group.summaryName = "geometric mean, 95 % interval";
  group.scale = AxisScale::kLog;
  group.legend = false;
  group.linked = true;
  group.series = {{"Conditions", {}}};
  std::map<std::string, int> subjects;
  for (const ConditionThresholds& condition : conditions) {
    for (const auto& [subject, threshold] : condition.bySubject) {
      subjects[subject] = 0;
    }
  }
  for (const TrialView view : work.analysis.data.conditions.all()) {
    const ConditionThresholds& condition = conditions[indexOfCondition(view)];
    const SubjectNumbers numbers = logThresholds(condition);
    GroupValues values = groupOfSubjects(numbers, ValueScale::kLogarithm);
    values.raw.clear();
    for (const auto& [subject, place] : subjects) {
      const auto found = numbers.bySubject.find(subject);
      values.raw.push_back(found == numbers.bySubject.end() ? kNotKnown : std::exp(found->second));
    }
    PsychometricPlot::Condition drawn{labelOf(work, view), sharesOf(condition), {}, std::nullopt};
    drawn.curve = curveOf(condition, drawn.points);
    if (std::isfinite(values.summary.value)) {
      drawn.threshold = values.summary;
    }
    plot.guess = condition.trials.empty() ? plot.guess : condition.guess;
    plot.conditions.push_back(std::move(drawn));
    if (!numbers.bySubject.empty()) {
      group.conditions.push_back(labelOf(work, view));
      group.series[0].groups.push_back(std::move(values));
    }
  }
  addFigure(work,
            "Shares of right answers by level, all subjects together (areas go with the number of trials), the mean of "
            "the subjects' fitted curves, and the mean threshold with its interval; dashed is guessing",
            fmt::format("figure-{}-curves", id), [&] { return psychometricFigure(plot); });
  if (!group.conditions.empty()) {
    addFigure(work, "Thresholds by condition: one dot a subject, joined within subjects", fmt::format("figure-{}", id),
              [&] { return groupFigure(group); });
  }
}

}  // namespace

void addThresholdSection(ReportWork& work, const ReportTask& task, const TrialList& trials) {
  const Conditions conditions = thresholdsOf(work.analysis.data.conditions, trials);
  const std::string id = fmt::format("thresholds-{}", namePart(task.name));
  const PsychometricModel model;
  addHeading(work.document, 2, fmt::format("Thresholds of {}", task.name), id);
  work.document.add(ReportParagraph{fmt::format(
      "Staircases hold the share of right answers where they want it, so that it does not tell how conditions differ: "
      "thresholds do. Each subject has a {} psychometric function of the log level in each condition; at the threshold "
      "it has risen by {} from guessing to what lapses leave.",
      model.shape->name, model.shape->threshold)});
  addThresholdCounts(work, id, conditions);
  addThresholdTables(work, id, conditions);
  addThresholdFigures(work, id, conditions);
  work.methods.push_back(fmt::format(
      "Thresholds of {} are modes of the posterior of {} psychometric functions of the log level, one a subject and "
      "condition, with the guess rate of the trials: flat prior of log threshold, log slope normal around {:.2f} with "
      "standard deviation {:g}, lapse rate up to {:g} with a density in proportion to (1 - lapse)^{:g}. Conditions "
      "were "
      "compared by differences of log thresholds within subjects (Student's t).",
      task.trialsName, model.shape->name, model.logSlopeMean, model.logSlopeDeviation, kMaxLapse, kLapseWeight));
}

}  // namespace ocelli
