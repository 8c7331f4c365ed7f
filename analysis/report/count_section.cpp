#include "analysis/report/count_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/mcnemar.h"
#include "analysis/inference/wilcoxon.h"
#include "analysis/plot/histogram_plot.h"
#include "analysis/report/count_conditions.h"
#include "analysis/report/right_answers.h"
#include "analysis/report/right_model.h"

namespace ocelli {
namespace {

constexpr double kFarthest = 1e6;  // beyond the end of any histogram

/// Scenes of a subject's session that are alike but for the view, in the order in which they came.
std::vector<PairedOutcome> matchedScenes(const TrialList& trials) {
  std::map<std::string, int> seen;
  std::vector<PairedOutcome> outcomes;
  for (const Trial* trial : trials) {
    const std::string scene = fmt::format("{}/{}/{}/{}/{}/{}", trial->subject, trial->session, trial->block,
                                          trial->exposureSeconds.value_or(-1), trial->objects.value_or(-1),
                                          trial->duplicateColors.value_or(false));
    const int number = seen[fmt::format("{}/{}", scene, nameOf(trial->view))]++;
    outcomes.push_back(
        {fmt::format("{}/{}", scene, number), trial->view == TrialView::kGraph, trial->correct.value_or(false)});
  }
  return outcomes;
}

void addMatched(ReportWork& work, const PlannedModel& model, const TrialList& trials) {
  const PairedCounts counts = pairOutcomes(matchedScenes(trials));
  const Estimable<McNemarTest> test = mcNemarTest(counts);
  if (!test) {
    work.outcomes.push_back({model.name, "", Estimable<double>::impossible(test.reason())});
    addNotEstimable(work.document, "McNemar's test", test.reason());
    return;
  }
  work.outcomes.push_back({model.name, "", test->exactP});
  const std::string source = fmt::format(
      "{} pairs of scenes of the same subject, session, block, exposure, number of "
      "objects and duplicates; {} trials have no partner",
      counts.pairs(), counts.unpaired);
  Estimate difference = test->difference;
  difference.pValue = test->exactP;
  addEstimates(work.document, "McNemar's test on matched scenes (pairs taken as independent)", model.name,
               {{"gc less ppc: difference of shares, exact p", difference, "", source, trials},
                {"Odds ratio gc / ppc", test->oddsRatio, "", source, trials}});
  work.document.add(ReportParagraph{fmt::format("Right in both {}, only in ppc {}, only in gc {}, in neither {}.",
                                                counts.both, counts.onlyFirst, counts.onlySecond, counts.neither)});
}

void addErrors(ReportWork& work, const PlannedModel& model, const TrialList& trials) {
  HistogramPlot plot;
  plot.title = "How far counts were off";
  plot.widthMillimetres = kDoubleColumnMillimetres;
  std::map<std::string, std::array<std::vector<double>, 2>> bySubject;
  for (const TrialView view : {TrialView::kPinhole, TrialView::kGraph}) {
    HistogramPlot::Series series{nameOf(view), {}};
    for (const Trial* trial : trialsOfView(trials, view)) {
      const std::optional<double> answer = numberIn(trial->answer);
      const std::optional<double> expected = numberIn(trial->expected);
      if (answer && expected) {
        ++series.counts[static_cast<int>(std::lround(std::clamp(*answer - *expected, -kFarthest, kFarthest)))];
        bySubject[trial->subject][view == TrialView::kGraph].push_back(*answer - *expected);
      }
    }
    plot.series.push_back(series);
  }
  work.document.add(ReportFigure{plot.title, "figure-count-errors", histogramFigure(plot)});
  std::vector<double> differences;
  for (const auto& [subject, views] : bySubject) {
    if (!views[0].empty() && !views[1].empty()) {
      const auto mean = [](const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) {
          sum += value;
        }
        return sum / static_cast<double>(values.size());
      };
      differences.push_back(mean(views[1]) - mean(views[0]));
    }
  }
  if (differences.empty()) {
    addNotEstimable(work.document, "Signed error", "no subject has answers in both views");
    return;
  }
  const Estimable<SignedRankTest> test = signedRankTest(differences);
  const Estimable<Estimate> center =
      test ? Estimable<Estimate>(test->center) : Estimable<Estimate>::impossible(test.reason());
  work.outcomes.push_back(
      {model.name, "", test ? Estimable<double>(test->center.pValue) : Estimable<double>::impossible(test.reason())});
  addEstimates(
      work.document, "Signed error (answer less true number): gc less ppc, one mean a subject, Wilcoxon", model.name,
      {{"Hodges-Lehmann center", center, "", fmt::format("{} subjects with both views", differences.size()), trials}});
}

}  // namespace

void addCountSection(ReportWork& work) {
  addHeading(work.document, 1, "Counting objects", "count");
  TrialList trials = trialsOfTask(work.analysis, "count");
  std::erase_if(trials, [](const Trial* trial) { return !trial->correct; });
  if (trials.empty()) {
    addNotEstimable(work.document, "Counts", "there are no trials of this task");
    return;
  }
  addRightAnswers(work, trials, "Counts", "count-shares", std::nullopt);
  addCountConditions(work, trials);
  addHeading(work.document, 2, "Models and tests", "count-models");
  for (const PlannedModel& model : work.analysis.plan.models) {
    if (model.task != "count") {
      continue;
    }
    if (model.kind == ModelKind::kBinomialMixed) {
      addRightModel(work, model, trials,
                    "Binomial mixed model of right counts: odds ratios, Wald's intervals and tests");
    } else if (model.kind == ModelKind::kMcNemar) {
      addMatched(work, model, trials);
    } else if (model.kind == ModelKind::kSignedError) {
      addErrors(work, model, trials);
    } else {
      addNotEstimable(work.document, fmt::format("Model {}", model.name),
                      fmt::format("{} is not done for counts", nameOf(model.kind)));
    }
  }
  work.methods.push_back(
      "Right counts were compared by a binomial mixed model (Laplace's approximation) with random effects of subjects "
      "and cases, and by McNemar's exact test on scenes that differ in the view alone.");
}

}  // namespace ocelli
