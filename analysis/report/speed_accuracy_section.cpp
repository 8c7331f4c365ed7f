#include "analysis/report/speed_accuracy_section.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <set>

#include "analysis/plot/trade_off_plot.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/subject_means.h"

namespace ocelli {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Trials with an answer that is right or wrong, and a time.
struct AnswersWithTimes {
  TrialValues logarithms{};  ///< of seconds
  TrialValues right{};       ///< 1, or 0

  explicit AnswersWithTimes(const TrialList& trials) {
    for (const Trial* trial : trials) {
      if (trial->correct && trial->responseSeconds && *trial->responseSeconds > 0 && !trial->censored.value_or(false)) {
        logarithms.push_back({trial, std::log(*trial->responseSeconds)});
        right.push_back({trial, *trial->correct ? 1.0 : 0.0});
      }
    }
  }
};

/// Of each subject with both: mean logarithm of right answers less that of wrong ones.
SubjectNumbers rightLessWrong(const TrialValues& logarithms) {
  TrialValues right;
  TrialValues wrong;
  for (const TrialValue& value : logarithms) {
    (*value.trial->correct ? right : wrong).push_back(value);
  }
  return subjectDifferences(subjectMeans(wrong), subjectMeans(right));
}

double meanOf(const SubjectNumbers& numbers) {
  double sum = 0;
  for (const auto& [subject, number] : numbers.bySubject) {
    sum += number;
  }
  return numbers.bySubject.empty() ? kUnknown : sum / static_cast<double>(numbers.bySubject.size());
}

TradeOffPlot plotOf(const ReportWork& work, const ReportTask& task, const AnswersWithTimes& answers) {
  TradeOffPlot plot;
  plot.title = fmt::format("{}: speed against accuracy", task.title);
  plot.timeLabel = "Time to answer (s)";
  plot.shareLabel = task.rightName;
  std::set<std::string> subjects;
  for (const TrialValue& value : answers.right) {
    subjects.insert(value.trial->subject);
  }
  for (const TrialView view : work.analysis.data.conditions.all()) {
    const SubjectNumbers times = subjectMeans(valuesOfView(answers.logarithms, view));
    const SubjectNumbers shares = subjectMeans(valuesOfView(answers.right, view));
    TradeOffPlot::Condition condition{labelOf(work, view), {}, {std::exp(meanOf(times)), meanOf(shares)}};
    for (const std::string& subject : subjects) {
      const auto found = times.bySubject.find(subject);
      condition.subjects.push_back(found == times.bySubject.end()
                                       ? TradeOffPlot::Point{kUnknown, kUnknown}
                                       : TradeOffPlot::Point{std::exp(found->second), shares.bySubject.at(subject)});
    }
    plot.conditions.push_back(std::move(condition));
  }
  return plot;
}

void addTask(ReportWork& work, const ReportTask& task) {
  addHeading(work.document, 2, task.title, fmt::format("speed-accuracy-{}", namePart(task.name)));
  const AnswersWithTimes answers(trialsOfTask(work.analysis, task.name));
  if (answers.right.empty()) {
    addNotEstimable(work.document, task.title, "no trial has both a time and an answer that is right or wrong");
    return;
  }
  addPart(work, fmt::format("The figure of {}", task.title), [&] {
    addFigure(work, fmt::format("{}: speed against accuracy", task.title),
              fmt::format("figure-speed-accuracy-{}", namePart(task.name)),
              [&] { return tradeOffFigure(plotOf(work, task, answers)); });
  });
  std::vector<EstimateRow> rows;
  for (const TrialView view : work.analysis.data.conditions.all()) {
    const ViewConditions& conditions = work.analysis.data.conditions;
    const std::string label = conditions.isPair() ? markOf(view) : conditions.nameOf(view);
    const TrialValues times = valuesOfView(answers.logarithms, view);
    rows.push_back(untested(rowOfSubjects(fmt::format("{}: time to answer (s)", label), subjectMeans(times),
                                          ValueScale::kLogarithm, "geometric means")));
    rows.push_back(
        untested(rowOfSubjects(fmt::format("{}: share of right answers", label),
                               subjectMeans(valuesOfView(answers.right, view)), ValueScale::kShare, "shares")));
    const SubjectNumbers differences = rightLessWrong(times);
    EstimateRow row = rowOfSubjects(fmt::format("{}: time of right answers / of wrong ones ({} subjects with both)",
                                                label, differences.bySubject.size()),
                                    differences, scaleOfDifferences(ValueScale::kLogarithm),
                                    "differences of logarithms (right less wrong)");
    if (differences.bySubject.size() < 2) {
      row.estimate = Estimable<Estimate>::impossible("fewer than two subjects have both right and wrong answers");
    }
    rows.push_back(row);
  }
  addEstimates(work.document,
               fmt::format("{}: speed against accuracy, means over subjects with 95 % intervals", task.title),
               fmt::format("speed-accuracy-{}", namePart(task.name)), rows);
}

}  // namespace

void addSpeedAccuracySection(ReportWork& work, const std::vector<ReportTask>& tasks) {
  std::vector<ReportTask> wanted;
  for (const ReportTask& task : tasks) {
    if (task.hasTrials && !task.isTimed) {
      wanted.push_back(task);
    }
  }
  if (wanted.empty()) {
    return;
  }
  addHeading(work.document, 1, "Speed against accuracy", "speed-accuracy");
  work.document.add(
      ReportParagraph{"A view may make answers slower and more often right, or quick and wrong, without showing more. "
                      "Each subject counts "
                      "once in each view, with its geometric mean time and its share of right answers; trials without "
                      "an answer are left "
                      "out. Where right answers take longer than wrong ones (a ratio above 1), taking time helps; "
                      "where they are quicker, "
                      "hard trials are both slow and wrong. Nothing here is corrected for the other."});
  for (const ReportTask& task : wanted) {
    addTask(work, task);
  }
  work.methods.push_back(
      "Speed and accuracy were described by the geometric mean time and the share of right answers of each subject in "
      "each "
      "view, and by the ratio of the times of right and wrong answers within subjects, with Student's intervals.");
}

}  // namespace ocelli
