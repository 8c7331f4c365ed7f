#include "analysis/report/path_section.h"

#include <fmt/format.h>

#include "analysis/dataset/protocol_facts.h"
#include "analysis/inference/bayes_factor.h"
#include "analysis/inference/equivalence.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/right_answers.h"
#include "analysis/report/right_model.h"

namespace ocelli {
namespace {

constexpr double kUsualMaps = 3;  // section 7.4.4

ValueRow withInterval(ValueRow row, const Interval& interval) {
  row.interval = interval;
  return row;
}

void addEquivalence(ReportWork& work, const PlannedModel& model, const TrialList& trials) {
  for (const PlannedEquivalence& planned : work.analysis.plan.equivalence) {
    if (planned.task != "path") {
      continue;
    }
    const Estimable<EquivalenceTest> test =
        shareEquivalence(trials, {planned.lower, planned.upper}, work.analysis.plan.alpha);
    if (!test) {
      work.outcomes.push_back({model.name, "", Estimable<double>::impossible(test.reason())});
      addNotEstimable(work.document, "Equivalence of the views", test.reason());
      return;
    }
    work.outcomes.push_back({model.name, "", test->pValue,
                             TestedEffect{"difference of shares of right paths, @other@ less @reference@",
                                          test->difference, 1 - 2 * test->alpha}});
    const std::string source =
        fmt::format("{} subjects with both views, one difference each; subjects and cases as clusters", test->first);
    const auto row = [&](const std::string& what, const std::string& text, std::optional<double> value) {
      return ValueRow{what, text, value, source, trials};
    };
    addValues(work.document,
              fmt::format("Two one-sided tests against the bounds of {}, {} to {} (@other@ less @reference@): mean of "
                          "the subjects' differences, "
                          "subjects and cases as clusters",
                          planName(work.analysis.plan), planned.lower, planned.upper),
              model.name,
              {row("Difference of shares", numberText(test->difference.value), test->difference.value),
               withInterval(
                   row(fmt::format("{:g} % interval", 100 * (1 - 2 * test->alpha)),
                       fmt::format("{} to {}", numberText(test->difference.lower), numberText(test->difference.upper)),
                       std::nullopt),
                   intervalOf(test->difference)),
               row(kEquivalenceTestRow, numberText(test->pValue), test->pValue),
               row("Equivalent", test->equivalent ? "yes" : "not shown", std::nullopt)});
    return;
  }
  work.outcomes.push_back({model.name, "", Estimable<double>::impossible("the plan has no bounds for paths")});
  addNotEstimable(work.document, "Equivalence of the views", "the plan has no bounds for paths");
}

void addBayes(ReportWork& work, const PlannedModel& model, const TrialList& trials) {
  const Estimable<Estimate> difference = shareDifference(trials);
  const Estimable<BayesFactor> factor =
      difference ? bayesFactorOfEstimate(*difference) : Estimable<BayesFactor>::impossible(difference.reason());
  if (!factor) {
    addNotEstimable(work.document, "Bayes factor", factor.reason());
    return;
  }
  const std::string source = fmt::format("t of {:.3g} with {:g} degrees of freedom, of {}", difference->statistic,
                                         difference->degreesOfFreedom, sizeText(trials));
  addValues(
      work.document,
      "Bayes factor of the difference of shares (Jeffreys-Zellner-Siow, medium scale) from its t with subjects and "
      "cases as clusters: for other subjects and other cases of their kind",
      model.name,
      {{"For none, against some", numberText(factor->forNone), factor->forNone, source, trials},
       {"For some, against none", numberText(factor->forEffect), factor->forEffect, source, trials}});
}

void addAgainstChance(ReportWork& work, const PlannedModel& model, const TrialList& trials, double chance) {
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

}  // namespace

double pathChance(const Dataset& data) {
  for (const DataSource& source : data.sources) {
    if (!source.protocolText.empty()) {
      for (const ProtocolBlockFacts& block : protocolFacts(source.protocolText, source.path).blocks) {
        if (block.task == "path" && block.maps) {
          return 1.0 / *block.maps;
        }
      }
    }
  }
  return 1 / kUsualMaps;
}

void addPathSection(ReportWork& work) {
  addHeading(work.document, 1, "Recognising paths", "path");
  TrialList trials = trialsOfTask(work.analysis, "path");
  std::erase_if(trials, [](const Trial* trial) { return !trial->correct; });
  if (trials.empty()) {
    addNotEstimable(work.document, "Paths", "there are no trials of this task");
    return;
  }
  const double chance = pathChance(work.analysis.data);
  addPart(work, "Paths that are right", [&] { addRightAnswers(work, trials, "Paths", "path-shares", chance); });
  for (const PlannedModel& model : work.analysis.plan.models) {
    if (model.task != "path") {
      continue;
    }
    addPart(work, wordsOf(model), [&] {
      if (model.kind == ModelKind::kBinomialMixed) {
        addRightModel(work, model, trials,
                      "Binomial mixed model of right paths: odds ratios, variances by restricted likelihood, intervals "
                      "and tests by Satterthwaite's degrees of freedom");
      } else if (model.kind == ModelKind::kEquivalence) {
        addEquivalence(work, model, trials);
      } else if (model.kind == ModelKind::kBayesFactor) {
        addBayes(work, model, trials);
      } else if (model.kind == ModelKind::kAgainstChance) {
        addAgainstChance(work, model, trials, chance);
      } else {
        addNotEstimable(work.document, wordsOf(model), fmt::format("{} is not done for paths", nameOf(model.kind)));
      }
    });
  }
  work.methods.push_back(fmt::format(
      "Whether paths are recognised equally well was tested by two one-sided tests of the mean of the subjects' "
      "differences of shares against the bounds of {}, with errors robust to clusters of subjects and of cases, a "
      "Bayes factor of the same t beside them, and against chance by an exact test.",
      planName(work.analysis.plan)));
}

}  // namespace ocelli
