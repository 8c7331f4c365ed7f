#include "analysis/report/count_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/plot/forest_plot.h"
#include "analysis/plot/group_plot.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/resampled_effects.h"
#include "analysis/report/right_answers.h"

namespace ocelli {
namespace {

/// Trials by view, duration and duplicates.
class Conditions {
 public:
  explicit Conditions(const TrialList& trials) : trials_(trials) {
    std::set<double> seconds;
    std::set<bool> duplicates;
    for (const Trial* trial : trials) {
      seconds.insert(*trial->exposureSeconds);
      duplicates.insert(*trial->duplicateColors);
    }
    seconds_.assign(seconds.begin(), seconds.end());
    duplicates_.assign(duplicates.begin(), duplicates.end());
  }

  const TrialList& trials() const { return trials_; }
  const std::vector<double>& seconds() const { return seconds_; }
  const std::vector<bool>& duplicates() const { return duplicates_; }
  size_t cellCount() const { return kViews.size() * seconds_.size() * duplicates_.size(); }

  size_t cell(TrialView view, size_t second, size_t duplicate) const {
    return (second * duplicates_.size() + duplicate) * kViews.size() + static_cast<size_t>(view);
  }
  size_t cellOf(const Trial* trial) const {
    const auto second = std::find(seconds_.begin(), seconds_.end(), *trial->exposureSeconds) - seconds_.begin();
    const size_t duplicate = duplicates_.front() == *trial->duplicateColors ? 0 : 1;
    return cell(trial->view, static_cast<size_t>(second), duplicate);
  }
  TrialList trialsOf(size_t cell) const {
    TrialList list = trials_;
    std::erase_if(list, [&](const Trial* trial) { return cellOf(trial) != cell; });
    return list;
  }
  std::string name(size_t second, size_t duplicate) const {
    return fmt::format("{:g} s, colours {}", seconds_[second], duplicates_[duplicate] ? "shared" : "different");
  }

 private:
  TrialList trials_;
  std::vector<double> seconds_{};
  std::vector<bool> duplicates_{};
};

std::vector<double> sharesOfSubjects(const TrialList& trials) {
  std::map<std::string, TrialList> bySubject;
  for (const Trial* trial : trials) {
    bySubject[trial->subject].push_back(trial);
  }
  std::vector<double> shares;
  for (const auto& [subject, own] : bySubject) {
    const Share share = shareOf(own);
    shares.push_back(static_cast<double>(share.successes) / share.trials);
  }
  return shares;
}

void addShares(ReportWork& work, const Conditions& conditions) {
  std::vector<EstimateRow> rows;
  for (size_t duplicate = 0; duplicate < conditions.duplicates().size(); ++duplicate) {
    const bool shared = conditions.duplicates()[duplicate];
    GroupPlot plot;
    plot.title = fmt::format("Counts that are right, colours {}", shared ? "shared" : "all different");
    plot.conditionLabel = "Seconds shown";
    plot.valueLabel = "Right answers";
    plot.percent = true;
    plot.connected = true;
    plot.summaryName = "share of all trials, 95 % interval";
    plot.widthMillimetres = kDoubleColumnMillimetres;
    plot.series = {{labelOf(work, TrialView::kReference), {}}, {labelOf(work, TrialView::kOther), {}}};
    for (size_t second = 0; second < conditions.seconds().size(); ++second) {
      plot.conditions.push_back(fmt::format("{:g}", conditions.seconds()[second]));
      for (const TrialView view : kViews) {
        const TrialList here = conditions.trialsOf(conditions.cell(view, second, duplicate));
        GroupValues values{{kNotKnown, kNotKnown, kNotKnown}, sharesOfSubjects(here)};
        if (!here.empty()) {
          const Estimate share = wilsonShare(shareOf(here));
          values.summary = intervalOf(share);
          rows.push_back({fmt::format("{}, {}", conditions.name(second, duplicate), markOf(view)), share, "",
                          fmt::format("{} right of {}", shareOf(here).successes, sizeText(here)), here});
        }
        plot.series[static_cast<size_t>(view)].groups.push_back(values);
      }
    }
    addFigure(work, plot.title + ", by duration; each dot is a subject",
              fmt::format("figure-count-conditions-{}", shared ? "shared" : "different"),
              [&] { return groupFigure(plot); });
  }
  addEstimates(work.document,
               "Counts that are right by duration and duplicates: shares with Wilson's intervals, which take trials as "
               "independent",
               "count-conditions", rows);
}

void addDifferences(ReportWork& work, const Conditions& conditions) {
  const TrialList& trials = conditions.trials();
  std::vector<double> right;
  std::vector<int> cells;
  for (const Trial* trial : trials) {
    right.push_back(trial->correct.value_or(false) ? 1 : 0);
    cells.push_back(static_cast<int>(conditions.cellOf(trial)));
  }
  const size_t seconds = conditions.seconds().size();
  const size_t duplicates = conditions.duplicates().size();
  std::vector<ResampledEffect> effects;
  const auto add = [&](const std::string& label, const std::vector<double>& weights) {
    effects.push_back(
        {label, bootstrapContrast(trials, right, cells, weights, bootstrapPlanOf(work.analysis.plan)), trials});
  };
  /// Adds `weight` times other less reference.
  const auto put = [&](std::vector<double>& weights, size_t second, size_t duplicate, double weight) {
    weights[conditions.cell(TrialView::kOther, second, duplicate)] += weight;
    weights[conditions.cell(TrialView::kReference, second, duplicate)] -= weight;
  };
  ForestPlot forest;
  forest.title = "Views in each condition";
  forest.valueLabel = withLabels(work, "Difference of shares, @other@ less @reference@");
  forest.lowerSide = fmt::format("{} better", labelOf(work, TrialView::kReference));
  forest.upperSide = fmt::format("{} better", labelOf(work, TrialView::kOther));
  for (size_t duplicate = 0; duplicate < duplicates; ++duplicate) {
    for (size_t second = 0; second < seconds; ++second) {
      std::vector<double> weights(conditions.cellCount());
      put(weights, second, duplicate, 1);
      add(conditions.name(second, duplicate), weights);
      const Estimable<BootstrapResult>& result = effects.back().result;
      ForestPlot::Row row;
      row.label = effects.back().label;
      if (result) {
        row.interval = intervalOf(result->percentile);
      } else {
        row.reason = "cannot be estimated";
      }
      forest.rows.push_back(row);
    }
  }
  if (duplicates == 2) {
    std::vector<double> weights(conditions.cellCount());
    for (size_t second = 0; second < seconds; ++second) {
      put(weights, second, 1, 1.0 / static_cast<double>(seconds));
      put(weights, second, 0, -1.0 / static_cast<double>(seconds));
    }
    add("Interaction: shared less different colours", weights);
  }
  if (seconds > 1) {
    std::vector<double> weights(conditions.cellCount());
    for (size_t duplicate = 0; duplicate < duplicates; ++duplicate) {
      put(weights, seconds - 1, duplicate, 1.0 / static_cast<double>(duplicates));
      put(weights, 0, duplicate, -1.0 / static_cast<double>(duplicates));
    }
    add(fmt::format("Interaction: {:g} s less {:g} s", conditions.seconds().back(), conditions.seconds().front()),
        weights);
  }
  if (std::any_of(effects.begin(), effects.end(), [](const auto& effect) { return effect.result.isPossible(); })) {
    addFigure(work,
              "Difference of shares of right counts in each condition, percentile intervals of "
              "resampled subjects and cases",
              "figure-count-differences", [&] { return forestFigure(forest); });
  }
  addResampled(work,
               "Difference of shares (@other@ less @reference@) in each condition, and between conditions (each weighs "
               "the same), by "
               "resampling subjects and cases",
               "count-differences", effects);
}

}  // namespace

void addCountConditions(ReportWork& work, const TrialList& trials) {
  TrialList known = trials;
  std::erase_if(known, [](const Trial* trial) { return !trial->exposureSeconds || !trial->duplicateColors; });
  addHeading(work.document, 2, "By duration and duplicates", "count-by-condition");
  if (known.empty()) {
    addNotEstimable(work.document, "Counts by duration and duplicates", "no trial says how long it showed what");
    return;
  }
  if (known.size() < trials.size()) {
    work.document.add(ReportNote{NoteKind::kNote,
                                 fmt::format("{} trials do not say their condition.", trials.size() - known.size())});
  }
  const Conditions conditions(known);
  addShares(work, conditions);
  addDifferences(work, conditions);
}

}  // namespace ocelli
