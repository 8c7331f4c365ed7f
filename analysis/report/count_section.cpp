#include "analysis/report/count_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/wilcoxon.h"
#include "analysis/plot/histogram_plot.h"
#include "analysis/report/count_conditions.h"
#include "analysis/report/count_pairs.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/right_answers.h"
#include "analysis/report/right_model.h"

namespace ocelli {
namespace {

constexpr double kFarthest = 1e6;  // beyond the end of any histogram

void addOutcome(ReportWork& work, const PlannedModel& model, const Estimable<Estimate>& difference,
                const std::string& measure) {
  if (difference) {
    work.outcomes.push_back({model.name, "", difference->pValue, TestedEffect{measure, *difference}});
  } else {
    work.outcomes.push_back({model.name, "", Estimable<double>::impossible(difference.reason())});
  }
}

void addMatched(ReportWork& work, const ReportTask& /*task*/, const PlannedModel& model, const TrialList& trials) {
  const PairedCounts counts = pairOutcomes(matchedScenes(trials));
  const Estimable<McNemarTest> test = mcNemarTest(counts);
  if (!test) {
    work.outcomes.push_back({model.name, "", Estimable<double>::impossible(test.reason())});
    addNotEstimable(work.document, "McNemar's test", test.reason());
    return;
  }
  const Estimable<Estimate> clustered = matchedDifference(trials);
  addOutcome(work, model, clustered,
             "difference of shares of right counts in matched scenes, @other@ less @reference@");
  const std::string source = fmt::format(
      "{} pairs of scenes of the same subject, session, block, exposure, number of "
      "objects and duplicates; {} trials have no partner",
      counts.pairs(), counts.unpaired);
  Estimate difference = test->difference;
  difference.pValue = test->exactP;
  addEstimates(
      work.document,
      "Matched scenes: difference of shares with subjects and kinds of scenes as clusters, and McNemar's test, "
      "which takes pairs as independent and rejects too often where scenes, or the gains of subjects, differ",
      model.name,
      {{"@other@ less @reference@: difference of shares, clustered", clustered, "", source, trials},
       {"@other@ less @reference@: difference of shares, McNemar's exact p", difference, "", source, trials},
       {"Odds ratio @other@ / @reference@, McNemar", test->oddsRatio, "", source, trials}});
  work.document.add(
      ReportParagraph{fmt::format("Right in both {}, only in @reference@ {}, only in @other@ {}, in neither {}.",
                                  counts.both, counts.onlyFirst, counts.onlySecond, counts.neither)});
}

void addErrors(ReportWork& work, const ReportTask& /*task*/, const PlannedModel& model, const TrialList& trials) {
  HistogramPlot plot;
  plot.title = "How far counts were off";
  plot.widthMillimetres = kDoubleColumnMillimetres;
  for (const TrialView view : kViews) {
    HistogramPlot::Series series{labelOf(work, view), {}};
    for (const Trial* trial : trialsOfView(trials, view)) {
      if (const std::optional<double> error = signedError(*trial)) {
        ++series.counts[static_cast<int>(std::lround(std::clamp(*error, -kFarthest, kFarthest)))];
      }
    }
    plot.series.push_back(series);
  }
  addFigure(work, plot.title, "figure-count-errors", [&] { return histogramFigure(plot); });
  const std::vector<double> differences = errorDifferences(trials);
  if (differences.empty()) {
    addNotEstimable(work.document, "Signed error", "no subject has answers in both views");
    return;
  }
  const Estimable<SignedRankTest> test = signedRankTest(differences);
  const Estimable<Estimate> center =
      test ? Estimable<Estimate>(test->center) : Estimable<Estimate>::impossible(test.reason());
  const Estimable<Estimate> clustered = errorDifference(trials);
  addOutcome(work, model, clustered, "difference of mean signed errors in objects, @other@ less @reference@");
  const std::string source = fmt::format("{} subjects with both views", differences.size());
  addEstimates(work.document,
               "Signed error (answer less true number): @other@ less @reference@, one mean a subject. The mean counts "
               "subjects and "
               "cases as drawn from more of theirs; Wilcoxon's test holds for these very cases",
               model.name,
               {{"Mean, subjects and cases as clusters", clustered, "", source, trials},
                {"Hodges-Lehmann center, Wilcoxon", center, "", source, trials}});
}

void addCountSection(ReportWork& work, const ReportTask& task) {
  addHeading(work.document, 1, "Counting objects", task.name);
  const TrialList trials = answeredTrials(trialsOfTask(work.analysis, task.name));
  if (trials.empty()) {
    addNotEstimable(work.document, "Counts", "there are no trials of this task");
    return;
  }
  addPart(work, "Counts that are right",
          [&] { addRightAnswers(work, trials, "Counts", "count-shares", std::nullopt); });
  addPart(work, "Counts by duration and duplicates", [&] { addCountConditions(work, trials); });
  addHeading(work.document, 2, "Models and tests", "count-models");
  addTaskModels(work, task, trials);
  work.methods.push_back(
      "Right counts were compared by a binomial mixed model with random effects of subjects and cases (variances by "
      "restricted likelihood, Laplace's approximation; Satterthwaite's degrees of freedom) and, on scenes that differ "
      "in "
      "the view alone, by the difference of shares with errors robust to clusters of subjects and of scenes (Cameron, "
      "Gelbach and Miller 2011), beside McNemar's exact test.");
}

}  // namespace

ReportTask countReportTask() {
  ReportTask task;
  task.name = "count";
  task.title = "Counting";
  task.trialsName = "counts";
  task.timesOutcome = task.rightOutcome = "right counts";
  task.parts = {{"Counting objects", "counts", 0.5, addCountSection}};
  task.modelKinds = {{ModelKind::kBinomialMixed, addRightModel},
                     {ModelKind::kMcNemar, addMatched},
                     {ModelKind::kSignedError, addErrors}};
  task.models = {{"count-right",
                  "count",
                  ModelKind::kBinomialMixed,
                  {"view", "exposure", "duplicates", "session", "moving"},
                  {{"subject", {"view"}}, {"case", {"view"}}}},
                 {"count-matched", "count", ModelKind::kMcNemar},
                 {"count-error", "count", ModelKind::kSignedError}};
  task.hypotheses = {{{"count-better", "Counts are right more or less often with the @other@ than with @reference@s",
                       "count-right", "view"},
                      true}};
  return task;
}

}  // namespace ocelli
