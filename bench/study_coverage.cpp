#include "bench/study_coverage.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/accelerated_failure_time.h"
#include "analysis/inference/cox.h"
#include "analysis/inference/equivalence.h"
#include "analysis/inference/mcnemar.h"
#include "analysis/inference/wilcoxon.h"
#include "analysis/report/count_pairs.h"
#include "analysis/report/error_model.h"
#include "analysis/report/planned_model.h"
#include "analysis/report/report_task.h"
#include "analysis/report/right_answers.h"
#include "analysis/report/search_times.h"

namespace ocelli {
namespace {

bool hasWarning(const PlannedFit& fit, const std::string& words) {
  return std::any_of(fit.warnings.begin(), fit.warnings.end(),
                     [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

StudyOutcome outcomeOf(const Estimable<PlannedFit>& fit) {
  StudyOutcome outcome;
  if (!fit) {
    return outcome;
  }
  outcome.singular = hasWarning(*fit, "singular");
  outcome.unconverged = hasWarning(*fit, "did not converge");
  for (const TermEstimate& term : fit->terms) {
    if (term.estimate) {
      outcome.terms.push_back({term.term, *term.estimate});
    }
  }
  return outcome;
}

template <class Test, class EstimateOf>
StudyOutcome outcomeOf(const Estimable<Test>& test, const std::string& name, const EstimateOf& estimateOf) {
  return test ? StudyOutcome{{{name, estimateOf(*test)}}} : StudyOutcome{};
}

StudyOutcome survivalOf(const PlannedModel& model, const TrialList& list) {
  const SurvivalData data = survivalDataOf(model, list, TimeoutTreatment::kCensored);
  StudyOutcome outcome;
  const auto keep = [&](const std::string& column, const Estimate& estimate) {
    for (const std::string& term : model.terms) {
      if (columnOfTerm(model, list, term) == column) {
        outcome.terms.push_back({term, estimate});
      }
    }
  };
  if (model.kind == ModelKind::kCox) {
    const Estimable<CoxFit> fit = fitCox(data);
    for (size_t i = 0; fit && i < fit->terms.size(); ++i) {
      keep(fit->terms[i].name, fit->terms[i].logHazardRatio);
    }
  } else {
    const Estimable<FailureTimeFit> fit = fitLogNormal(data);
    for (size_t i = 0; fit && i < fit->terms.size(); ++i) {
      keep(fit->terms[i].name, fit->terms[i].logTimeRatio);
    }
  }
  return outcome;
}

void addTo(StudyOutcome& outcome, const std::string& name, const Estimable<Estimate>& estimate) {
  if (estimate) {
    outcome.terms.push_back({name, *estimate});
  }
}

/// The difference with the interval of 90 %, and the p value of "not equivalent".
Estimate tost(const EquivalenceTest& test) {
  Estimate difference = test.difference;
  difference.pValue = test.pValue;
  return difference;
}

// What a test without terms takes as independent of each other, or as drawn from more.
constexpr const char* kPairs = "pairs";
constexpr const char* kSubjects = "subjects";
constexpr const char* kClusters = "subjects, cases";

}  // namespace

StudyOutcome analyseStudy(const PlannedModel& model, const std::vector<Trial>& trials) {
  const TrialList list = listOf(trials);
  switch (model.kind) {
    case ModelKind::kLinearMixed:
    case ModelKind::kLogNormalMixed:
      return outcomeOf(fitTimes(model, list, TimeoutTreatment::kCensored));
    case ModelKind::kBinomialMixed:
      return outcomeOf(fitBinomial(model, list));
    case ModelKind::kCox:
    case ModelKind::kLogNormalSurvival:
      return survivalOf(model, list);
    case ModelKind::kKaplanMeier:
      return outcomeOf(restrictedMeanDifferenceOf(list, TimeoutTreatment::kCensored, *trials.front().longestSeconds),
                       "difference", [](const RestrictedMeanDifference& difference) { return difference.difference; });
    case ModelKind::kMcNemar: {
      StudyOutcome outcome =
          outcomeOf(mcNemarTest(pairOutcomes(matchedScenes(list))), kPairs, [](const McNemarTest& test) {
            Estimate difference = test.difference;
            difference.pValue = test.exactP;
            return difference;
          });
      addTo(outcome, kClusters, matchedDifference(list));
      return outcome;
    }
    case ModelKind::kSignedError: {
      StudyOutcome outcome = outcomeOf(signedRankTest(errorDifferences(list)), kSubjects,
                                       [](const SignedRankTest& test) { return test.center; });
      addTo(outcome, kClusters, errorDifference(list));
      return outcome;
    }
    case ModelKind::kEquivalence: {
      const PlannedEquivalence planned = defaultPlan().equivalence.front();
      const EquivalenceBounds bounds{planned.lower, planned.upper};
      StudyOutcome outcome = outcomeOf(equivalenceOfPairedMeans(shareDifferences(list), bounds), kSubjects, tost);
      if (const Estimable<EquivalenceTest> test = shareEquivalence(list, bounds, kAlpha)) {
        outcome.terms.push_back({kClusters, tost(*test)});
      }
      return outcome;
    }
    case ModelKind::kSignedErrorMixed:
    case ModelKind::kAbsoluteErrorMixed:
      return outcomeOf(fitErrors(model, trialsOfErrorModel(model, list)));
    case ModelKind::kAgainstChance:
      return outcomeOf(binomialTest(shareOf(list), 1.0 / 3), "share",
                       [](const BinomialTest& test) { return test.clopperPearson; });
    case ModelKind::kBayesFactor:
    case ModelKind::kOrdinal:
      break;
  }
  return {};
}

CoverageResult coverageOf(const PlannedModel& model, const SimulatedStudy& study,
                          const std::map<std::string, double>& truths, const CoverageRun& run) {
  std::vector<StudyOutcome> outcomes(static_cast<size_t>(run.studies));
  tbb::parallel_for(size_t{0}, outcomes.size(), [&](size_t i) {
    RandomNumbers numbers(run.seed, i);
    outcomes[i] = analyseStudy(model, study.draw(numbers));
  });
  CoverageResult result;
  result.studies = run.studies;
  std::map<std::string, std::vector<Estimate>> byTerm;
  std::vector<std::string> names;
  for (const StudyOutcome& outcome : outcomes) {
    result.impossible += outcome.terms.empty() ? 1 : 0;
    result.singular += outcome.singular ? 1 : 0;
    result.unconverged += outcome.unconverged ? 1 : 0;
    for (const ReportedTerm& term : outcome.terms) {
      if (!byTerm.contains(term.name)) {
        names.push_back(term.name);
      }
      byTerm[term.name].push_back(term.estimate);
    }
  }
  for (const std::string& name : names) {
    const std::vector<Estimate>& estimates = byTerm[name];
    TermCoverage term;
    term.name = name;
    term.truth = truths.contains(name) ? truths.at(name) : 0;
    term.studies = static_cast<int>(estimates.size());
    double squares = 0;
    double reported = 0;
    for (const Estimate& estimate : estimates) {
      term.meanError += (estimate.value - term.truth) / term.studies;
    }
    for (const Estimate& estimate : estimates) {
      if (std::isfinite(estimate.lower)) {
        ++term.covered.trials;
        ++term.coveredMean.trials;
        const double mean = term.truth + term.meanError;
        term.coveredMean.successes += estimate.lower <= mean && mean <= estimate.upper ? 1 : 0;
        term.covered.successes += estimate.lower <= term.truth && term.truth <= estimate.upper ? 1 : 0;
      }
      if (std::isfinite(estimate.pValue)) {
        ++term.rejected.trials;
        term.rejected.successes += estimate.pValue < kAlpha ? 1 : 0;
      }
      const double error = estimate.value - term.truth;
      squares += error * error;
      reported += estimate.standardError * estimate.standardError;
    }
    term.deviation = std::sqrt(std::max(0.0, squares / term.studies - term.meanError * term.meanError));
    term.standardError = std::sqrt(reported / term.studies);
    result.terms.push_back(term);
  }
  return result;
}

namespace {

/// Over the scenes that have a partner.
double matchedTruth(const SimulatedStudy& study) {
  const std::vector<PairedOutcome> outcomes = matchedScenes(listOf(study.planned()));
  const std::vector<double> probabilities = study.probabilities();
  std::map<std::string, std::array<std::optional<double>, 2>> pairs;
  for (size_t i = 0; i < outcomes.size(); ++i) {
    pairs[outcomes[i].pair][outcomes[i].isSecond] = probabilities[i];
  }
  double sum = 0;
  double count = 0;
  for (const auto& [name, pair] : pairs) {
    if (pair[0] && pair[1]) {
      sum += *pair[1] - *pair[0];
      ++count;
    }
  }
  return sum / count;
}

}  // namespace

std::vector<CoverageScenario> coverageScenarios() {
  std::vector<CoverageScenario> scenarios;
  const auto add = [&](const std::string& name, const std::string& model, const std::string& what,
                       const SimulatedTruth& truth, bool balanced = false) {
    scenarios.push_back({name, model, what, truth, balanced});
  };
  SimulatedTruth find;
  find.average = 2.5;
  find.effects = {{"view", -0.3}, {"session", -0.1}, {"moving", -0.3}, {"view:session", -0.05}, {"view:moving", 0.1}};
  find.ofSubjects = 0.25;
  find.ofSubjectViews = 0.15;
  find.ofItems = 0.35;
  find.ofTrials = 0.45;
  add("find-time", "find-time", "log times, no limit reached", find);
  SimulatedTruth limited = find;
  limited.limitSeconds = 60;
  add("find-time-60s", "find-time", "the same with time-outs at 60 s, which count as 60 s", limited);
  SimulatedTruth alike = find;
  alike.ofSubjectViews = 0;
  add("find-time-no-slopes", "find-time", "subjects gain alike from the view", alike);

  SimulatedTruth marginal = limited;
  marginal.effects = {{"view", -0.3}, {"session", -0.1}, {"moving", -0.3}};
  add("find-log-normal", "find-log-normal", "subjects and items differ", marginal);
  marginal.ofItems = 0;
  add("find-log-normal-alike", "find-log-normal", "items do not differ", marginal);
  SimulatedTruth hazard;
  hazard.outcome = SimulatedOutcome::kHazards;
  hazard.average = -2.7;
  hazard.effects = {{"view", 0.5}, {"session", 0.15}, {"moving", 0.5}};
  hazard.frailty = 0.8;
  hazard.limitSeconds = 60;
  add("find-hazard-alike", "find-hazard", "items do not differ", hazard);
  hazard.ofItems = 0.5;
  add("find-hazard", "find-hazard", "subjects and items differ", hazard);
  add("find-restricted-mean", "find-survival", "subjects and items differ", limited);

  SimulatedTruth count;
  count.outcome = SimulatedOutcome::kAnswers;
  count.average = 0.8;
  count.effects = {{"view", 1.2}, {"exposure", 0.03}, {"duplicates", -0.4}, {"session", 0.2}, {"moving", -0.2}};
  count.ofSubjects = 0.5;
  count.ofItems = 0.4;
  add("count", "count-right", "a case has one view, the same for all", count);
  add("count-balanced", "count-right", "cases have the views in turn over subjects", count, true);
  SimulatedTruth sloped = count;
  sloped.ofSubjectViews = 0.4;
  add("count-slopes", "count-right", "subjects differ in the view's effect, which the model does not have", sloped);
  add("count-slopes-fitted", "count-right", "the same, with slopes in the model", sloped);
  scenarios.back().slopes = true;
  SimulatedTruth countAlike = count;
  countAlike.ofSubjects = countAlike.ofItems = 0;
  add("count-alike", "count-right", "neither subjects nor items differ", countAlike);
  add("count-matched", "count-matched", "subjects and items differ", count);
  add("count-matched-alike", "count-matched", "neither subjects nor items differ", countAlike);
  SimulatedTruth countSubjects = count;
  countSubjects.ofItems = 0;
  add("count-matched-subjects", "count-matched", "subjects differ, items do not", countSubjects);
  add("count-matched-balanced", "count-matched", "views in turn over subjects", count, true);
  add("count-error-alike", "count-error", "subjects and items differ in how often they are right only", count);
  SimulatedTruth tooMany = count;
  tooMany.ofErrors = 0.8;
  tooMany.effects = {};
  add("count-error", "count-error", "items differ in whether wrong counts are too many; no effect", tooMany);
  add("count-error-balanced", "count-error", "the same with views in turn over subjects", tooMany, true);

  SimulatedTruth path;
  path.outcome = SimulatedOutcome::kAnswers;
  path.average = 0.75;
  path.effects = {{"view", 0.3}, {"session", 0.2}};
  path.ofSubjects = 0.5;
  path.ofItems = 0.4;
  add("path", "path-right", "a case has one view, the same for all", path);
  add("path-balanced", "path-right", "cases have the views in turn over subjects", path, true);
  SimulatedTruth pathSloped = path;
  pathSloped.ofSubjectViews = 0.4;
  add("path-slopes", "path-right", "subjects differ in the view's effect, which the model does not have", pathSloped);
  add("path-slopes-fitted", "path-right", "the same, with slopes in the model", pathSloped);
  scenarios.back().slopes = true;
  SimulatedTruth pathAlike = path;
  pathAlike.ofSubjects = pathAlike.ofItems = 0;
  add("path-alike", "path-right", "neither subjects nor items differ", pathAlike);
  SimulatedTruth guessing = pathAlike;
  guessing.average = std::log(0.5);
  add("path-guessing", "path-right", "around the chance of 1/3, nobody differs", guessing);
  // A difference of 0.1 in shares over what may be drawn.
  SimulatedTruth bound = path;
  bound.effects = {{"view", 0.489}};
  add("path-equivalence", "path-equivalence", "at the bound; a case has one view", bound);
  add("path-equivalence-balanced", "path-equivalence", "at the bound; views in turn over subjects", bound, true);
  SimulatedTruth boundAlike = bound;
  boundAlike.ofSubjects = boundAlike.ofItems = 0;
  boundAlike.effects = {{"view", 0.4605}};
  add("path-equivalence-alike", "path-equivalence", "at the bound; nobody differs", boundAlike);
  guessing.effects = {};
  add("path-chance", "path-chance", "all guess", guessing);
  return scenarios;
}

PlannedModel modelOf(const CoverageScenario& scenario) {
  PlannedModel model = *defaultPlan().findModel(scenario.model);
  for (RandomEffect& effect : model.randomEffects) {
    if (model.kind == ModelKind::kBinomialMixed && effect.group == "subject") {
      effect.slopes = scenario.slopes ? std::vector<std::string>{"view"} : std::vector<std::string>{};
    }
  }
  return model;
}

SimulatedStudy studyOf(const CoverageScenario& scenario, const Protocol& protocol, bool null) {
  Protocol ordered = protocol;
  if (scenario.balanced) {
    for (ProtocolBlock& block : ordered.blocks) {
      block.order = TrialOrder::kBalanced;
    }
  }
  SimulatedTruth truth = scenario.truth;
  if (null) {
    truth.effects.clear();
  }
  const AnalysisPlan plan = defaultPlan();
  return {plannedTrials(ordered, plan.findModel(scenario.model)->task, sessionsOf2010()), truth};
}

std::map<std::string, double> reportedTruths(const CoverageScenario& scenario, const SimulatedStudy& study) {
  const AnalysisPlan plan = defaultPlan();
  const ModelKind kind = plan.findModel(scenario.model)->kind;
  std::map<std::string, double> truths = study.truth().effects;
  if (kind == ModelKind::kCox) {
    for (auto& [term, effect] : truths) {
      effect *= study.truth().frailty;
    }
  } else if (kind == ModelKind::kEquivalence) {
    truths = {{kSubjects, study.shareDifference()}, {kClusters, study.shareDifference()}};
  } else if (kind == ModelKind::kMcNemar) {
    truths = {{kPairs, matchedTruth(study)}, {kClusters, matchedTruth(study)}};
  } else if (kind == ModelKind::kAgainstChance) {
    truths = {{"share", 1.0 / 3}};
  } else if (kind == ModelKind::kKaplanMeier) {
    truths = {{"difference", study.limitedMeanDifference()}};
  }
  return truths;
}

}  // namespace ocelli
