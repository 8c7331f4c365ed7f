#include "analysis/report/path_section.h"

#include <fmt/format.h>

#include "analysis/dataset/protocol_facts.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/right_answers.h"
#include "analysis/report/right_model.h"
#include "analysis/report/share_models.h"

namespace ocelli {
namespace {

constexpr double kUsualMaps = 3;  // section 7.4.4

void addAgainstChance(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& trials) {
  const double chance = chanceOf(work.analysis.data, task.name);
  std::vector<EstimateRow> rows;
  const auto add = [&](const std::string& label, const TrialList& some) {
    const Estimable<BinomialTest> test = binomialTest(shareOf(some), chance);
    rows.push_back({label,
                    test ? Estimable<Estimate>(test->clopperPearson) : Estimable<Estimate>::impossible(test.reason()),
                    "", fmt::format("{} right of {}", shareOf(some).successes, sizeText(some)), some});
    return test;
  };
  const Estimable<BinomialTest> both = add("Both views", trials);
  if (both) {
    work.outcomes.push_back(
        {model.name, "", both->clopperPearson.pValue,
         TestedEffect{fmt::format("share of right paths, chance {:.3f}", chance), both->clopperPearson}});
  } else {
    work.outcomes.push_back({model.name, "", Estimable<double>::impossible(both.reason())});
  }
  add("@reference@", trialsOfView(trials, TrialView::kReference));
  add("@other@", trialsOfView(trials, TrialView::kOther));
  addEstimates(
      work.document,
      fmt::format("Shares of right paths against a chance of {:.3f}, exact; trials taken as independent", chance),
      model.name, rows);
}

void addPathSection(ReportWork& work, const ReportTask& task) {
  addHeading(work.document, 1, "Recognising paths", task.name);
  const TrialList trials = answeredTrials(trialsOfTask(work.analysis, task.name));
  if (trials.empty()) {
    addNotEstimable(work.document, "Paths", "there are no trials of this task");
    return;
  }
  const double chance = chanceOf(work.analysis.data, task.name);
  addPart(work, "Paths that are right", [&] { addRightAnswers(work, trials, "Paths", "path-shares", chance); });
  addTaskModels(work, task, trials);
  work.methods.push_back(fmt::format(
      "Whether paths are recognised equally well was tested by two one-sided tests of the mean of the subjects' "
      "differences of shares against the bounds of {}, with errors robust to clusters of subjects and of cases, a "
      "Bayes factor of the same t beside them, and against chance by an exact test.",
      planName(work.analysis.plan)));
}

}  // namespace

double chanceOf(const Dataset& data, const std::string& task) {
  for (const DataSource& source : data.sources) {
    if (!source.protocolText.empty()) {
      for (const ProtocolBlockFacts& block : protocolFacts(source.protocolText, source.path).blocks) {
        if (block.task == task && block.maps) {
          return 1.0 / *block.maps;
        }
      }
    }
  }
  return 1 / kUsualMaps;
}

ReportTask pathReportTask() {
  ReportTask task;
  task.name = "path";
  task.title = "Recognising paths";
  task.trialsName = "paths";
  task.timesOutcome = task.rightOutcome = "right paths";
  task.parts = {{"Recognising paths", "paths", 0.9, addPathSection}};
  task.modelKinds = {{ModelKind::kBinomialMixed, addRightModel},
                     {ModelKind::kEquivalence, addEquivalenceModel},
                     {ModelKind::kBayesFactor, addBayesModel},
                     {ModelKind::kAgainstChance, addAgainstChance}};
  task.models = {{"path-right",
                  "path",
                  ModelKind::kBinomialMixed,
                  {"view", "session"},
                  {{"subject", {"view"}}, {"case", {"view"}}}},
                 {"path-equivalence", "path", ModelKind::kEquivalence},
                 {"path-bayes", "path", ModelKind::kBayesFactor},
                 {"path-chance", "path", ModelKind::kAgainstChance}};
  task.hypotheses = {{{"path-alike", "Paths are recognised equally well in both views", "path-equivalence", ""}, true},
                     {{"path-above-chance", "Paths are recognised more often than by guessing", "path-chance", ""}}};
  task.equivalence = PlannedEquivalence{"path", -0.1, 0.1};
  return task;
}

}  // namespace ocelli
