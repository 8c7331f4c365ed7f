#include "analysis/report/learning_section.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>

#include "analysis/plot/figure_grid.h"
#include "analysis/report/learning_change.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/search_times.h"

namespace ocelli {
namespace {

struct Condition {
  std::string name;
  TrialValues values;
};

/// What is followed over trials.
struct Outcome {
  std::string name;  ///< "Time to find (s)"
  std::string id;
  ValueScale scale = ValueScale::kPlain;
  const BlockHalves* blocks = nullptr;
  TrialValues values{};  ///< logarithms of times; 1 for right answers, 0 for others

  bool isTime() const { return scale == ValueScale::kLogarithm; }
  std::vector<Condition> sessions() const {
    std::set<int> numbers;
    for (const TrialValue& value : values) {
      numbers.insert(value.trial->session);
    }
    std::vector<Condition> conditions;
    for (const int number : numbers) {
      conditions.push_back({std::to_string(number), valuesOfSession(values, number)});
    }
    return conditions;
  }
  std::vector<Condition> halves() const {
    return {{"First", blocks->valuesOf(values, BlockHalf::kFirst)},
            {"Second", blocks->valuesOf(values, BlockHalf::kSecond)}};
  }
};

Outcome timesOf(const ReportTask& task, const TrialList& trials, const BlockHalves& blocks, TimeoutTreatment timeouts) {
  Outcome outcome{task.timeName, "times", ValueScale::kLogarithm, &blocks};
  for (const Trial* trial : trials) {
    const bool removed = timeouts == TimeoutTreatment::kRemoved && isCensored(trial);
    if (trial->responseSeconds && *trial->responseSeconds > 0 && !removed) {
      outcome.values.push_back({trial, std::log(*trial->responseSeconds)});
    }
  }
  return outcome;
}

Outcome rightAnswersOf(const ReportTask& task, const TrialList& trials, const BlockHalves& blocks) {
  Outcome outcome{task.rightName, "right", ValueScale::kShare, &blocks};
  for (const Trial* trial : trials) {
    if (trial->correct) {
      outcome.values.push_back({trial, *trial->correct ? 1.0 : 0.0});
    }
  }
  return outcome;
}

GroupPlot chartOf(const ReportWork& work, const std::string& title, const std::string& conditionLabel,
                  const Outcome& outcome, const std::vector<Condition>& conditions, double widthMillimetres) {
  GroupPlot plot;
  plot.title = title;
  plot.conditionLabel = conditionLabel;
  plot.valueLabel = outcome.name;
  plot.summaryName = "mean of subjects (geometric of times), 95 % interval";
  plot.scale = outcome.isTime() ? AxisScale::kLog : AxisScale::kLinear;
  plot.percent = !outcome.isTime();
  plot.connected = true;
  plot.legend = false;
  plot.widthMillimetres = widthMillimetres;
  plot.heightMillimetres = 58;
  plot.series = {{labelOf(work, TrialView::kReference), {}}, {labelOf(work, TrialView::kOther), {}}};
  for (const Condition& condition : conditions) {
    plot.conditions.push_back(condition.name);
    for (size_t v = 0; v < kViews.size(); ++v) {
      const SubjectNumbers means = subjectMeans(valuesOfView(condition.values, kViews[v]));
      plot.series[v].groups.push_back(groupOfSubjects(means, outcome.scale));
    }
  }
  return plot;
}

void addFigure(ReportWork& work, const std::string& task, const std::string& title,
               const std::vector<Outcome>& outcomes) {
  FigureGrid grid;
  grid.title = fmt::format("{}: times and right answers as subjects practise", title);
  for (const Outcome& outcome : outcomes) {
    const double width = grid.columnMillimetres();
    const GroupPlot sessions = chartOf(work, "By session", "Session", outcome, outcome.sessions(), width);
    grid.legend = groupLegend(sessions);
    grid.figures.push_back(groupFigure(sessions));
    if (!outcome.blocks->isEmpty()) {
      grid.figures.push_back(
          groupFigure(chartOf(work, "Within blocks", "Half of a block", outcome, outcome.halves(), width)));
    }
  }
  addFigure(work, grid.title, fmt::format("figure-learning-{}", task), [&] { return gridFigure(grid); });
}

void addMeans(ReportWork& work, const std::string& id, const Outcome& outcome) {
  ComparisonTable table;
  table.caption = fmt::format(
      "{}: {} with 95 % intervals; subjects of @reference@, of @other@, and of both", outcome.name,
      outcome.isTime() ? "geometric means over the geometric means of subjects" : "means over the shares of subjects");
  table.id = id;
  table.difference = outcome.isTime() ? "@other@ / @reference@" : "@other@ less @reference@";
  for (const Condition& session : outcome.sessions()) {
    table.rows.push_back(compareViews(fmt::format("Session {}", session.name), session.values, outcome.scale));
  }
  if (!outcome.blocks->isEmpty()) {
    for (const Condition& half : outcome.halves()) {
      table.rows.push_back(compareViews(fmt::format("{} halves of blocks", half.name), half.values, outcome.scale));
    }
  }
  addComparison(work.document, table);
}

/// Of either view, and how the views differ. `change` makes one number a subject, 0 where nothing changes; subjects
/// without `needed` have none.
void addTrend(std::vector<EstimateRow>& rows, const Outcome& outcome, const std::string& label, const std::string& what,
              const std::string& needed, const std::function<SubjectNumbers(const TrialValues&)>& change) {
  const SubjectNumbers reference = change(valuesOfView(outcome.values, TrialView::kReference));
  const SubjectNumbers other = change(valuesOfView(outcome.values, TrialView::kOther));
  const ValueScale scale = scaleOfDifferences(outcome.scale);
  const auto add = [&](const std::string& which, const SubjectNumbers& numbers, ValueScale shownScale,
                       const std::string& numberOf) {
    const size_t count = numbers.bySubject.size();
    EstimateRow row = rowOfSubjects(fmt::format("{}, {} ({} subject{})", label, which, count, count == 1 ? "" : "s"),
                                    numbers, shownScale, numberOf);
    if (count < 2) {
      row.estimate =
          Estimable<Estimate>::impossible(fmt::format("{} subject has {}", count == 0 ? "no" : "only one", needed));
    }
    rows.push_back(row);
  };
  add("@reference@", reference, scale, what);
  add("@other@", other, scale, what);
  add(outcome.isTime() ? "@other@ / @reference@" : "@other@ less @reference@", subjectDifferences(reference, other),
      scaleOfDifferences(scale), fmt::format("differences (@other@ less @reference@) of {}", what));
}

void addTrends(ReportWork& work, const std::string& id, const Outcome& outcome) {
  std::vector<EstimateRow> rows;
  addTrend(rows, outcome, "From session to session", "slopes over sessions", "such trials in two sessions",
           sessionSlopes);
  if (!outcome.blocks->isEmpty()) {
    addTrend(rows, outcome, outcome.isTime() ? "Second half of a block / first" : "Second half of a block less first",
             "differences (second half less first)", "such trials in both halves of a block",
             [&](const TrialValues& values) { return halfDifferences(values, *outcome.blocks); });
  }
  addEstimates(work.document,
               fmt::format("{}: trends within subjects, {}", outcome.name,
                           outcome.isTime() ? "as ratios (below 1: times became shorter)"
                                            : "as changes of the share (above 0: it became larger)"),
               id, rows);
}

void addTask(ReportWork& work, const ReportTask& task) {
  const std::string& title = task.title;
  addHeading(work.document, 2, title, fmt::format("learning-{}", task.name));
  const TrialList trials = trialsOfTask(work.analysis, task.name);
  if (trials.empty()) {
    addNotEstimable(work.document, title, "there are no trials of this task");
    return;
  }
  const BlockHalves blocks(trials);
  std::vector<Outcome> outcomes;
  for (const Outcome& outcome :
       {timesOf(task, trials, blocks, task.timeouts(work.analysis.plan)), rightAnswersOf(task, trials, blocks)}) {
    if (outcome.values.empty()) {
      addNotEstimable(work.document, outcome.name, "no trial has a value");
    } else {
      outcomes.push_back(outcome);
    }
  }
  if (outcomes.empty()) {
    return;
  }
  addPart(work, fmt::format("The figure of {}", title), [&] { addFigure(work, task.name, title, outcomes); });
  for (const Outcome& outcome : outcomes) {
    addPart(work, outcome.name, [&] {
      addMeans(work, fmt::format("learning-{}-{}", task.name, outcome.id), outcome);
      addTrends(work, fmt::format("learning-{}-{}-trends", task.name, outcome.id), outcome);
    });
  }
  if (blocks.isEmpty()) {
    addNotEstimable(work.document, "Change within the blocks of a session", kNoHalves);
  }
}

}  // namespace

void addLearningSection(ReportWork& work, const std::vector<ReportTask>& tasks) {
  addHeading(work.document, 1, "Learning", "learning");
  const bool removed = work.analysis.plan.findTimeouts == TimeoutTreatment::kRemoved;
  work.document.add(ReportParagraph{fmt::format(
      "Each subject counts once, with its mean; intervals are for other subjects with the same cases. Means of a "
      "session are of those who came to it, so that they can change with who came. Trends are within subjects: from "
      "session to session the slope of the line through a subject's means, of subjects with two sessions or more; "
      "within a block of a session the second half of the trials of each view against the first (without the middle "
      "one "
      "of an odd number, blocks that are not complete, and cases that all subjects had in the same half). Trends hold "
      "all that changes with the trials, not learning alone. {}",
      removed ? "Searches whose time ran out are removed from the times."
              : "Searches whose time ran out count with the limit in the times, which makes their geometric means too "
                "short where there are many.")});
  for (const ReportTask& task : tasks) {
    addTask(work, task);
  }
  work.methods.push_back(
      "Learning was described by slopes over sessions and by differences between the halves of blocks, one of each a "
      "subject, with Student's intervals and tests.");
}

}  // namespace ocelli
