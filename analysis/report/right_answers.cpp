#include "analysis/report/right_answers.h"

#include <fmt/format.h>

#include <set>

#include "analysis/inference/crossed_clusters.h"
#include "analysis/inference/sample.h"
#include "analysis/plot/group_plot.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/resampled_effects.h"

namespace ocelli {

TrialList answeredTrials(TrialList trials) {
  std::erase_if(trials, [](const Trial* trial) { return !trial->correct; });
  return trials;
}

Share shareOf(const TrialList& trials) {
  Share share;
  for (const Trial* trial : trials) {
    share.successes += trial->correct.value_or(false) ? 1 : 0;
    ++share.trials;
  }
  return share;
}

std::vector<double> shareDifferences(const TrialList& trials) {
  std::map<std::string, std::array<TrialList, 2>> bySubject;
  for (const Trial* trial : trials) {
    bySubject[trial->subject][trial->view == TrialView::kOther].push_back(trial);
  }
  std::vector<double> differences;
  for (const auto& [subject, views] : bySubject) {
    if (!views[0].empty() && !views[1].empty()) {
      const auto rate = [](const Share& share) { return static_cast<double>(share.successes) / share.trials; };
      differences.push_back(differenceOf(rate(shareOf(views[0])), rate(shareOf(views[1]))));
    }
  }
  return differences;
}

Estimable<Estimate> shareDifference(const TrialList& trials) {
  std::vector<double> right;
  std::vector<bool> isOther;
  for (const Trial* trial : trials) {
    right.push_back(trial->correct.value_or(false) ? 1 : 0);
    isOther.push_back(trial->view == TrialView::kOther);
  }
  return clusteredMeanDifference(right, isOther, numbered(subjectsOf(trials)), caseNumbers(trials));
}

Estimable<EquivalenceTest> shareEquivalence(const TrialList& trials, const EquivalenceBounds& bounds, double alpha) {
  const Estimable<Estimate> difference = shareDifference(trials);
  if (!difference) {
    return Estimable<EquivalenceTest>::impossible(difference.reason());
  }
  EquivalenceTest test =
      equivalenceOf(difference->value, difference->standardError, difference->degreesOfFreedom, bounds, alpha);
  test.first = test.second = shareDifferences(trials).size();
  return test;
}

void addRightAnswers(ReportWork& work, const TrialList& trials, const std::string& what, const std::string& id,
                     std::optional<double> chance) {
  std::set<int> sessions;
  for (const Trial* trial : trials) {
    sessions.insert(trial->session);
  }
  GroupPlot plot;
  plot.title = fmt::format("{} that are right, by session", what);
  plot.conditionLabel = "Session";
  plot.valueLabel = "Right answers";
  plot.percent = true;
  plot.reference = chance;
  plot.referenceName = "chance";
  plot.summaryName = "share of all trials, 95 % interval";
  plot.widthMillimetres = kDoubleColumnMillimetres;
  std::vector<EstimateRow> rows;
  for (const TrialView view : kViews) {
    GroupSeries series{labelOf(work, view), {}};
    for (const int session : sessions) {
      TrialList here = trialsOfView(trials, view);
      std::erase_if(here, [&](const Trial* trial) { return trial->session != session; });
      std::map<std::string, TrialList> bySubject;
      for (const Trial* trial : here) {
        bySubject[trial->subject].push_back(trial);
      }
      GroupValues values{{kNotKnown, kNotKnown, kNotKnown}, {}};
      for (const auto& [subject, own] : bySubject) {
        const Share share = shareOf(own);
        values.raw.push_back(static_cast<double>(share.successes) / share.trials);
      }
      if (!here.empty()) {
        const Estimate share = wilsonShare(shareOf(here));
        values.summary = intervalOf(share);
        rows.push_back({fmt::format("{}, session {}", markOf(view), session), share, "",
                        fmt::format("{} right of {} with view {} in session {}", shareOf(here).successes,
                                    sizeText(here), markOf(view), session),
                        here});
      }
      series.groups.push_back(values);
    }
    plot.series.push_back(series);
  }
  for (const int session : sessions) {
    plot.conditions.push_back(std::to_string(session));
  }
  addFigure(work, plot.title, fmt::format("figure-{}", id), [&] { return groupFigure(plot); });
  addEstimates(work.document,
               fmt::format("{} that are right: shares with Wilson's intervals, which take trials as independent", what),
               id, rows);
}

}  // namespace ocelli
