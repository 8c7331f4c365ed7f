#include "analysis/report/completers_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "analysis/dataset/protocol_facts.h"
#include "analysis/inference/restricted_mean.h"
#include "analysis/inference/student.h"
#include "analysis/plot/figure_grid.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/search_times.h"
#include "analysis/report/subject_means.h"

namespace ocelli {
namespace {

using GroupResult = Estimable<Estimate>;

std::optional<int> plannedSessions(const Dataset& data) {
  for (const DataSource& source : data.sources) {
    if (!source.protocolText.empty()) {
      return protocolFacts(source.protocolText, source.path).sessions;
    }
  }
  return std::nullopt;
}

/// First sessions of those who completed all, and of those who did not.
class Groups {
 public:
  Groups(const AnalysisData& analysis, int planned) : analysis_(analysis) {
    const std::map<std::string, int> completed = completedSessions(analysis.data);
    for (const Trial& trial : analysis.data.trials) {
      const auto found = completed.find(trial.subject);
      const int sessions = found == completed.end() ? 0 : found->second;
      (sessions >= planned ? stayed_ : left_).insert(trial.subject);
      if (sessions < planned) {
        leftAfter_[trial.subject] = sessions;
      }
    }
  }

  size_t stayed() const { return stayed_.size(); }
  size_t left() const { return left_.size(); }
  /// "20 of them completed 1".
  std::string leftAfter() const {
    std::map<int, int> counts;
    for (const auto& [subject, sessions] : leftAfter_) {
      ++counts[sessions];
    }
    std::vector<std::string> parts;
    for (const auto& [sessions, count] : counts) {
      parts.push_back(fmt::format("{} of them completed {}", count, sessions == 0 ? "none" : std::to_string(sessions)));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
  }
  TrialList firstSessions(const std::string& task) const {
    TrialList trials = trialsOfTask(analysis_, task);
    std::erase_if(trials, [](const Trial* trial) { return trial->session != 1; });
    return trials;
  }
  bool hasStayed(const Trial* trial) const { return stayed_.contains(trial->subject); }

 private:
  const AnalysisData& analysis_;
  std::set<std::string> stayed_;
  std::set<std::string> left_;
  std::map<std::string, int> leftAfter_;
};

/// How two groups of subjects differ in a number of each.
ComparisonRow compareGroups(const std::string& label, const SubjectNumbers& stayed, const SubjectNumbers& left,
                            ValueScale scale, const std::string& what) {
  EstimateRow difference{
      fmt::format("{}, compared", label), welchDifference(numbersOf(stayed), numbersOf(left)), "",
      fmt::format("{}, {} subjects less {}, Welch's interval", what, left.bySubject.size(), stayed.bySubject.size()),
      stayed.trials};
  difference.trials.insert(difference.trials.end(), left.trials.begin(), left.trials.end());
  if (difference.estimate) {
    difference.estimate = shownOn(scaleOfDifferences(scale), *difference.estimate);
  }
  return {label, untested(rowOfSubjects(fmt::format("{}, completed", label), stayed, scale, what)),
          untested(rowOfSubjects(fmt::format("{}, did not", label), left, scale, what)), untested(difference),
          fmt::format("{}, {}", stayed.bySubject.size(), left.bySubject.size())};
}

ComparisonRow compareRestrictedMeans(const Groups& groups, const TrialList& trials, TimeoutTreatment timeouts) {
  const double limit = searchLimit(trials);
  const std::string label = fmt::format("Restricted mean to {:g} s (s)", limit);
  std::array<TrialList, 2> lists;
  std::vector<bool> isSecond;
  for (const Trial* trial : trials) {
    isSecond.push_back(!groups.hasStayed(trial));
    lists[isSecond.back() ? 1 : 0].push_back(trial);
  }
  const auto meanOf = [&](const TrialList& list, const char* which) {
    const auto mean = restrictedMean(timesOf(list, timeouts), limit, numbered(subjectsOf(list)));
    return EstimateRow{fmt::format("{}, {}", label, which),
                       mean ? GroupResult(mean->mean) : GroupResult::impossible(mean.reason()), "",
                       fmt::format("{}, first session, subjects as clusters", sizeText(list)), list};
  };
  const auto difference =
      restrictedMeanDifference(timesOf(trials, timeouts), isSecond, limit, numbered(subjectsOf(trials)));
  const auto count = [](const TrialList& list) {
    const std::vector<std::string> subjects = subjectsOf(list);
    return std::set<std::string>(subjects.begin(), subjects.end()).size();
  };
  return {label, meanOf(lists[0], "completed"), meanOf(lists[1], "did not"),
          untested({fmt::format("{}, compared", label),
                    difference ? GroupResult(difference->difference) : GroupResult::impossible(difference.reason()), "",
                    fmt::format("{}, first session, subjects as clusters", sizeText(trials)), trials}),
          fmt::format("{}, {}", count(lists[0]), count(lists[1]))};
}

TrialValues ofGroup(const Groups& groups, const TrialValues& values, bool stayed) {
  TrialValues some = values;
  std::erase_if(some, [&](const TrialValue& value) { return groups.hasStayed(value.trial) != stayed; });
  return some;
}

SubjectNumbers viewEffects(const TrialValues& values) {
  return subjectDifferences(subjectMeans(valuesOfView(values, TrialView::kReference)),
                            subjectMeans(valuesOfView(values, TrialView::kOther)));
}

/// What a task has to compare.
struct Measured {
  const ReportTask& task;
  TrialList trials;
  TrialValues logTimes{};  ///< of searches
  TrialValues right{};

  bool isEmpty() const { return logTimes.empty() && right.empty(); }
};

Measured measuredOf(const Groups& groups, const ReportTask& task, TimeoutTreatment timeouts) {
  Measured measured{task, groups.firstSessions(task.name)};
  for (const Trial* trial : measured.trials) {
    if (trial->correct) {
      measured.right.push_back({trial, *trial->correct ? 1.0 : 0.0});
    }
    const bool removed = timeouts == TimeoutTreatment::kRemoved && isCensored(trial);
    if (task.isTimed && trial->responseSeconds && *trial->responseSeconds > 0 && !removed) {
      measured.logTimes.push_back({trial, std::log(*trial->responseSeconds)});
    }
  }
  return measured;
}

void addFigure(ReportWork& work, const Groups& groups, const std::vector<Measured>& tasks) {
  FigureGrid grid;
  grid.title = "First sessions, by whether all sessions were completed";
  grid.columns = 3;
  for (const Measured& measured : tasks) {
    const bool times = !measured.logTimes.empty();
    const TrialValues& values = times ? measured.logTimes : measured.right;
    GroupPlot plot;
    plot.title = measured.task.title;
    plot.valueLabel = times ? measured.task.timeName : std::string("Share of right answers");
    plot.summaryName = "mean of subjects (geometric of times), 95 % interval";
    plot.scale = times ? AxisScale::kLog : AxisScale::kLinear;
    plot.percent = !times;
    plot.legend = false;
    plot.widthMillimetres = grid.columnMillimetres();
    plot.heightMillimetres = 55;
    plot.conditions = {"completed", "did not"};
    for (const TrialView view : kViews) {
      GroupSeries series{labelOf(work, view), {}};
      for (const bool stayed : {true, false}) {
        const TrialValues some = valuesOfView(ofGroup(groups, values, stayed), view);
        series.groups.push_back(
            groupOfSubjects(subjectMeans(some), times ? ValueScale::kLogarithm : ValueScale::kShare));
      }
      plot.series.push_back(series);
    }
    grid.legend = groupLegend(plot);
    grid.figures.push_back(groupFigure(plot));
  }
  addFigure(work, grid.title, "figure-completers", [&] { return gridFigure(grid); });
}

void addTable(ReportWork& work, const Groups& groups, const Measured& measured) {
  ComparisonTable table;
  table.caption =
      fmt::format("{} in the first session: means over subjects' means, with 95 % intervals; subjects of either group",
                  measured.task.title);
  table.id = fmt::format("completers-{}", measured.task.name);
  table.first = "Completed";
  table.second = "Did not";
  table.difference = "Did not, against completed";
  table.tested = false;
  const auto add = [&](const std::string& label, const std::string& effect, const TrialValues& values, ValueScale scale,
                       const std::string& what) {
    const TrialValues stayed = ofGroup(groups, values, true);
    const TrialValues left = ofGroup(groups, values, false);
    table.rows.push_back(compareGroups(label, subjectMeans(stayed), subjectMeans(left), scale, what));
    table.rows.push_back(compareGroups(effect, viewEffects(stayed), viewEffects(left), scaleOfDifferences(scale),
                                       fmt::format("differences (@other@ less @reference@) of {}", what)));
  };
  if (!measured.logTimes.empty()) {
    TrialList timed;
    for (const TrialValue& value : measured.logTimes) {
      timed.push_back(value.trial);
    }
    table.rows.push_back(compareRestrictedMeans(groups, timed, measured.task.timeouts(work.analysis.plan)));
    add("Geometric mean time (s), as a ratio", "Effect of the view on times, @other@ / @reference@, as a ratio",
        measured.logTimes, ValueScale::kLogarithm, "mean logarithms");
  }
  if (!measured.right.empty()) {
    add(measured.task.rightName, "Effect of the view on it, @other@ less @reference@", measured.right,
        ValueScale::kShare, "shares");
  }
  addComparison(work.document, table);
}

}  // namespace

void addCompletersSection(ReportWork& work, const std::vector<ReportTask>& tasks) {
  addHeading(work.document, 1, "Those who completed all sessions, and those who did not", "completers");
  const char* what = "Comparison of completers and drop-outs";
  const std::optional<int> planned = plannedSessions(work.analysis.data);
  if (!planned) {
    addNotEstimable(work.document, what, "without the protocol it is not known how many sessions were planned");
    return;
  }
  if (*planned < 2) {
    addNotEstimable(work.document, what, "the protocol has one session only");
    return;
  }
  const Groups groups(work.analysis, *planned);
  if (groups.stayed() == 0 || groups.left() == 0) {
    addNotEstimable(work.document, what,
                    groups.left() == 0
                        ? fmt::format("all {} analysed subjects completed the {} planned sessions, so there is one "
                                      "group only",
                                      groups.stayed(), *planned)
                        : fmt::format("none of {} analysed subjects completed the {} planned sessions, so there is one "
                                      "group only",
                                      groups.left(), *planned));
    return;
  }
  work.document.add(ReportParagraph{fmt::format(
      "{} of {} analysed subjects completed the {} planned sessions; {} did not, or have not yet: {}. Their first "
      "sessions are compared here. This is descriptive: nobody was assigned to leave, no hypothesis is tested, and "
      "that "
      "the groups are alike in what was measured does not show that they would have stayed alike. Subjects that the "
      "plan excludes are in neither group. Intervals are for other subjects with the same cases.",
      groups.stayed(), groups.stayed() + groups.left(), *planned, groups.left(), groups.leftAfter())});
  std::vector<Measured> all;
  for (const ReportTask& task : tasks) {
    Measured measured = measuredOf(groups, task, task.timeouts(work.analysis.plan));
    if (measured.isEmpty()) {
      addNotEstimable(work.document, fmt::format("{}, first session", measured.task.title),
                      "there are no trials of it");
    } else {
      all.push_back(std::move(measured));
    }
  }
  if (!all.empty()) {
    addPart(work, "The figure of first sessions", [&] { addFigure(work, groups, all); });
  }
  for (const Measured& measured : all) {
    addPart(work, fmt::format("{}, first session", measured.task.title), [&] { addTable(work, groups, measured); });
  }
}

}  // namespace ocelli
