// Whether 95 % intervals of what a report says of estimates and thresholds hold what was made true in 93 to 97 % of
// studies. 100 studies, or as many as OCELLI_TEST_STUDIES says (docs/results.md has 500). A share is accepted unless
// one in that range would be as far out with a probability below kByChance: with some 20 intervals and two sides each
// the test fails by chance in less than one run of 1,000.
#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <mutex>

#include "analysis/dataset/exclusions.h"
#include "analysis/inference/binomial_test.h"
#include "analysis/inference/circular.h"
#include "analysis/inference/student.h"
#include "analysis/report/condition_model.h"
#include "analysis/report/power_law.h"
#include "analysis/report/threshold_trials.h"
#include "analysis/report/view_test.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/random_numbers.h"
#include "tests/analysis_power/sham_tasks.h"

namespace ocelli::test {
namespace {

constexpr double kByChance = 2e-5;
constexpr int kSubjects = 24;

int studiesAsked(int otherwise) {
  const char* asked = std::getenv("OCELLI_TEST_STUDIES");
  return asked != nullptr ? std::atoi(asked) : otherwise;
}

/// What one study says, by name; and what is true.
using Told = std::map<std::string, Estimable<Estimate>>;
using True = std::map<std::string, double>;

/// Estimates are off the truth in the mean by no more than `bias` and five standard errors of that mean, as the
/// intervals have them.
void expectRecovered(const True& truths, const std::function<Told(uint64_t)>& study, double bias = 0) {
  struct Recovered {
    Share covered{};
    double sum = 0;
    double squares = 0;  ///< of standard errors
  };
  std::map<std::string, Recovered> recovered;
  const int studies = studiesAsked(100);
  std::mutex mutex;
  parallelFor(static_cast<size_t>(studies), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Told told = study(1000 + i);
      const std::lock_guard lock(mutex);
      for (const auto& [name, estimate] : told) {
        if (estimate) {
          Recovered& each = recovered[name];
          ++each.covered.trials;
          each.covered.successes += estimate->lower <= truths.at(name) && truths.at(name) <= estimate->upper ? 1 : 0;
          each.sum += estimate->value;
          each.squares += estimate->standardError * estimate->standardError;
        }
      }
    }
  });
  using boost::math::binomial;
  for (const auto& [name, truth] : truths) {
    const Recovered& each = recovered[name];
    ASSERT_EQ(each.covered.trials, studies) << name;
    const double successes = each.covered.successes;
    const double mean = each.sum / studies;
    std::printf("%s: %d of %d intervals hold %.3f; mean estimate %.3f\n", name.c_str(), static_cast<int>(successes),
                studies, truth, mean);
    EXPECT_GE(cdf(binomial(studies, 0.93), successes), kByChance) << name;
    EXPECT_GE(cdf(complement(binomial(studies, 0.97), successes - 1)), kByChance) << name;
    EXPECT_NEAR(mean, truth, bias + 5 * std::sqrt(each.squares) / studies) << name;
  }
}

AnalysisPlan planOf(const std::string& task) {
  return planFromJsonText(
      R"({"name": "sham", "models": [
          {"name": "signed", "task": ")" +
          task + R"(", "kind": "signed_error_mixed", "terms": ["view"],
           "random": [{"group": "subject", "slopes": ["view"]}, {"group": "case", "slopes": ["view"]}]},
          {"name": "absolute", "task": ")" +
          task + R"(", "kind": "absolute_error_mixed", "terms": ["view"],
           "random": [{"group": "subject", "slopes": ["view"]}, {"group": "case", "slopes": ["view"]}]}]})",
      "plan", {task});
}

/// Of a pair: the view in both models, as the section of two conditions fits them.
Told viewsOf(const AnalysisData& data, const std::vector<std::string>& models) {
  Told told;
  for (const std::string& model : models) {
    told.emplace(model, testOfView(data, *data.plan.findModel(model)).view);
  }
  return told;
}

TEST(EstimateRecovery, ofLengths) {
  const Protocol protocol = shamProtocol();
  GeneratorEffects effects;
  effects.at("reach", "error") = -0.25;
  effects.at("reach", "graph") = -0.15;
  const AnalysisPlan plan = planOf("reach");
  // Errors do not depend on the truth, so that estimates are in proportion to it.
  expectRecovered({{"signed", -0.15}, {"exponent", 1}, {"exponents differ", 0}}, [&](uint64_t seed) {
    const AnalysisData data = applyPlan(shamStudy(protocol, effects, kSubjects, seed), plan);
    Told told = viewsOf(data, {"signed"});
    const Estimable<PowerLawFit> law = fitPowerLaw(protocol.conditions.names, estimatesIn(trialsOfTask(data, "reach")));
    if (law) {
      told.emplace("exponent", law->conditions[1].exponent);
      told.emplace("exponents differ", law->conditions[1].difference);
    }
    return told;
  });
}

TEST(EstimateRecovery, ofAbsoluteErrors) {
  const Protocol protocol = shamProtocol();
  // Errors over subjects, cases and trials are normal with mean 0, and the log of their absolute values has a mean that
  // goes with the log of their deviation. The second view has the deviation of its effect on subjects besides.
  const GeneratorEffects effects;
  const auto square = [&](const char* deviation) { return std::pow(effects.at("bearing", deviation), 2); };
  const double first = square("subject_sd") + square("item_sd") + square("item_view_sd") / 4 + square("residual_sd");
  const double truth = std::log((first + square("subject_graph_sd")) / first) / 2;
  const AnalysisPlan plan = planOf("bearing");
  expectRecovered({{"absolute", truth}}, [&](uint64_t seed) {
    return viewsOf(applyPlan(shamStudy(protocol, effects, kSubjects, seed), plan), {"absolute"});
  });
}

TEST(EstimateRecovery, ofThreeConditions) {
  const Protocol protocol = shamProtocol(3);
  GeneratorEffects effects;
  effects.setCondition("reach", "bent", -0.15);
  effects.setCondition("reach", "high", 0.05);
  const AnalysisPlan plan = planOf("reach");
  const PlannedModel& model = *plan.findModel("signed");
  const std::vector<PlannedContrast> contrasts = contrastsOf(plan, model, protocol.conditions.names);
  expectRecovered({{"signed: bent / flat", -0.15}, {"signed: high / flat", 0.05}}, [&](uint64_t seed) {
    const AnalysisData data = applyPlan(shamStudy(protocol, effects, kSubjects, seed), plan);
    const Estimable<ConditionFit> fit =
        fitConditions(data.data, model, trialsOfTask(data, "reach"), TimeoutTreatment::kCensored, contrasts);
    Told told;
    for (size_t i = 0; fit && i < contrasts.size(); ++i) {
      told.emplace(contrasts[i].name, fit->contrasts[i].estimate);
    }
    return told;
  });
}

std::vector<MeanVector> vectorsOfView(const EstimateTrials& estimates, TrialView view) {
  std::map<std::string, std::vector<double>> angles;
  for (size_t i = 0; i < estimates.trials.size(); ++i) {
    if (estimates.trials[i]->view == view) {
      angles[estimates.trials[i]->subject].push_back(estimates.values[i].signedError() * M_PI / 180);
    }
  }
  std::vector<MeanVector> vectors;
  for (const auto& [subject, ofSubject] : angles) {
    vectors.push_back(meanVector(ofSubject));
  }
  return vectors;
}

/// The intervals of mean vectors are for other subjects on the same cases: cases are alike here.
TEST(EstimateRecovery, ofDirections) {
  const Protocol protocol = shamProtocol();
  GeneratorEffects effects;
  effects.at("bearing", "error") = 5;
  effects.at("bearing", "graph") = 12;
  const AnalysisPlan plan = planOf("bearing");
  expectRecovered({{"signed", 12}}, [&](uint64_t seed) {
    return viewsOf(applyPlan(shamStudy(protocol, effects, kSubjects, seed), plan), {"signed"});
  });
  effects.at("bearing", "item_sd") = 0;
  effects.at("bearing", "item_view_sd") = 0;
  effects.at("bearing", "residual_sd") = 40;
  constexpr double kDegree = M_PI / 180;
  expectRecovered({{"mean direction", 5 * kDegree}, {"turned by", 12 * kDegree}, {"lengths differ", 0}},
                  [&](uint64_t seed) {
                    const AnalysisData data = applyPlan(shamStudy(protocol, effects, kSubjects, seed), plan);
                    const EstimateTrials estimates = estimatesIn(trialsOfTask(data, "bearing"));
                    const auto first = vectorsOfView(estimates, TrialView::kReference);
                    const auto second = vectorsOfView(estimates, TrialView::kOther);
                    Told told;
                    told.emplace("turned by", directionDifference(first, second));
                    told.emplace("lengths differ", lengthDifference(first, second));
                    told.emplace("mean direction", circularMean(first)->direction);
                    return told;
                  });
}

/// A 3-down-1-up staircase (Levitt 1971) of 60 trials in each of two conditions, whose log thresholds differ by -0.3
/// over subjects; steps of a quarter.
Dataset staircases(uint64_t seed) {
  RandomNumbers numbers(seed);
  const PsychometricModel model;
  Dataset data;
  data.sources.push_back({});
  for (int subject = 0; subject < kSubjects; ++subject) {
    const double ofSubject = 0.4 * numbers.normal();
    for (const TrialView view : kViews) {
      const double threshold = ofSubject + (view == TrialView::kOther ? -0.3 : 0) + 0.15 * numbers.normal();
      int step = 6;
      int inARow = 0;
      for (int i = 0; i < 60; ++i) {
        const double level = 0.25 * step;
        const bool right = numbers.uniform() < rightProbability(model, {threshold, std::log(4.0), 0.02}, level);
        Trial trial;
        trial.trialId = static_cast<int64_t>(data.trials.size()) + 1;
        trial.subject = std::to_string(subject);
        trial.task = "nearer";
        trial.block = "stairs";
        trial.caseIndex = i;
        trial.view = view;
        trial.correct = right;
        trial.measures = {{"level", std::exp(level)}, {"guess_rate", 0.5}};
        data.trials.push_back(trial);
        inARow = right ? inARow + 1 : 0;
        step += right ? (inARow == 3 ? -1 : 0) : 1;
        inARow = inARow == 3 ? 0 : inARow;
      }
    }
  }
  return data;
}

// Thresholds of 60 trials of a staircase come out 0.04 too high here (docs/results.md); where conditions are compared
// that cancels.
TEST(EstimateRecovery, ofThresholds) {
  constexpr double kBias = 0.06;
  expectRecovered(
      {{"threshold of the first", 0}, {"thresholds differ", -0.3}},
      [&](uint64_t seed) {
        const Dataset data = staircases(seed);
        const auto conditions = thresholdsOf(data.conditions, trialsOfTask(data, "nearer"));
        const SubjectNumbers first = logThresholds(conditions[0]);
        Told told;
        told.emplace("threshold of the first", studentMean(numbersOf(first)));
        told.emplace("thresholds differ",
                     studentMean(numbersOf(subjectDifferences(first, logThresholds(conditions[1])))));
        return told;
      },
      kBias);
}

}  // namespace
}  // namespace ocelli::test
