#include "analysis/report/effect_sizes.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "analysis/inference/effect_size.h"
#include "analysis/inference/sample.h"
#include "analysis/inference/student.h"
#include "analysis/plot/paired_plot.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/right_answers.h"

namespace ocelli {
namespace {

void addSubjectEffects(std::vector<EstimateRow>& rows, const TrialList& trials, const SubjectMeans& means,
                       const std::string& what) {
  const std::string source = fmt::format("{} of {} subjects with both views", what, means.differences.size());
  const Estimable<PairedEffect> effect = pairedEffect(means.reference, means.other);
  const auto part = [&](const Estimate PairedEffect::*member) {
    return effect ? Estimable<Estimate>((*effect).*member) : Estimable<Estimate>::impossible(effect.reason());
  };
  if (!effect) {
    rows.push_back({"Standardised differences", Estimable<Estimate>::impossible(effect.reason())});
  } else {
    rows.push_back({"d_z: over the spread of differences", part(&PairedEffect::dz), "", source, trials});
    if (std::isfinite(effect->correctedDz.value)) {
      rows.push_back({"g_z: the same with Hedges' correction", part(&PairedEffect::correctedDz), "", source, trials});
    }
    rows.push_back({"d_av: over the spread within views", part(&PairedEffect::dav), "", source, trials});
  }
  rows.push_back({"Rank-biserial correlation of pairs", matchedRankBiserial(means.differences), "", source, trials});
}

/// A line a subject: who gained, and who did not. `plot` has its title and axis.
void addPairs(ReportWork& work, PairedPlot plot, const SubjectMeans& means, const std::string& id) {
  const bool isRatio = plot.scale == AxisScale::kLog;
  const auto shown = [&](double value) { return isRatio ? std::exp(value) : value; };
  for (size_t i = 0; i < means.reference.size(); ++i) {
    plot.pairs.push_back({shown(means.reference[i]), shown(means.other[i])});
  }
  for (const TrialView view : kViews) {
    const auto v = static_cast<size_t>(view);
    plot.conditions[v] = labelOf(work, view);
    const Estimable<Estimate> mean = studentMean(view == TrialView::kReference ? means.reference : means.other);
    plot.summaries[v] = !mean     ? Interval{kNotKnown, kNotKnown, kNotKnown}
                        : isRatio ? intervalOf(exponentiated(*mean))
                                  : intervalOf(*mean);
  }
  addFigure(work, fmt::format("{}: a line a subject; beside them the {}", plot.title, plot.summaryName),
            fmt::format("figure-{}-pairs", id), [&] { return pairedFigure(plot); });
}

}  // namespace

SubjectMeans subjectMeans(const TrialList& trials, const std::vector<double>& values) {
  struct Sum {
    double total = 0;
    double count = 0;
  };
  std::map<std::string, std::array<Sum, 2>> bySubject;
  for (size_t i = 0; i < trials.size(); ++i) {
    Sum& sum = bySubject[trials[i]->subject][trials[i]->view == TrialView::kOther];
    sum.total += values[i];
    sum.count += 1;
  }
  SubjectMeans means;
  for (const auto& [subject, views] : bySubject) {
    if (views[0].count > 0 && views[1].count > 0) {
      means.reference.push_back(views[0].total / views[0].count);
      means.other.push_back(views[1].total / views[1].count);
      means.differences.push_back(differenceOf(means.reference.back(), means.other.back()));
    }
  }
  return means;
}

void addTimeEffects(ReportWork& work, const TrialList& trials, const std::vector<double>& seconds,
                    const std::string& id) {
  std::vector<double> logs;
  for (const double time : seconds) {
    logs.push_back(std::log(time));
  }
  const SubjectMeans means = subjectMeans(trials, logs);
  PairedPlot plot;
  plot.title = "Times of each subject with either view";
  plot.valueLabel = "Geometric mean time (s)";
  plot.summaryName = "geometric mean of subjects, 95 % interval";
  plot.scale = AxisScale::kLog;
  addPairs(work, plot, means, id);
  std::vector<EstimateRow> rows;
  addSubjectEffects(rows, trials, means, "mean log times");
  addEstimates(work.document,
               "Sizes of the effect of the view on log times (@other@ less @reference@), one mean a subject", id, rows);
}

void addShareEffects(ReportWork& work, const TrialList& trials, const std::string& id) {
  const Share reference = shareOf(trialsOfView(trials, TrialView::kReference));
  const Share other = shareOf(trialsOfView(trials, TrialView::kOther));
  const std::string source =
      fmt::format("{} right of {} with @reference@, {} right of {} with @other@; trials taken as independent",
                  reference.successes, reference.trials, other.successes, other.trials);
  std::vector<EstimateRow> rows{{"Difference of shares", riskDifference(reference, other), "", source, trials},
                                {"Ratio of shares", riskRatio(reference, other), "", source, trials},
                                {"Odds ratio", oddsRatio(reference, other), "", source, trials}};
  std::vector<double> right;
  for (const Trial* trial : trials) {
    right.push_back(trial->correct.value_or(false) ? 1 : 0);
  }
  const SubjectMeans means = subjectMeans(trials, right);
  PairedPlot plot;
  plot.title = "Right answers of each subject with either view";
  plot.valueLabel = "Share of right answers";
  plot.summaryName = "mean of subjects, 95 % interval";
  plot.percent = true;
  addPairs(work, plot, means, id);
  addSubjectEffects(rows, trials, means, "shares of right answers");
  addEstimates(
      work.document,
      "Sizes of the effect of the view on right answers (@other@ against @reference@): the first three take trials as "
      "independent, the others have one share a subject",
      id, rows);
}

}  // namespace ocelli
