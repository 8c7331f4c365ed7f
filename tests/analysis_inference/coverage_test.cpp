// Whether intervals of 95 % hold the truth in 93 to 97 % of simulated studies: 45 subjects, 12 cases, two views,
// time-outs at 60 s.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <numeric>

#include "analysis/base/distributions.h"
#include "analysis/inference/accelerated_failure_time.h"
#include "analysis/inference/cox.h"
#include "analysis/inference/restricted_mean.h"
#include "analysis/inference/restricted_mean_bootstrap.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli::test {
namespace {

constexpr double kHorizon = 60;
constexpr int kSubjects = 45;
constexpr int kCases = 12;

/// Trials of a study; `expert` is of the subject.
struct Study {
  std::vector<SurvivalTime> times;
  std::vector<int> subjects;
  std::vector<int> cases;
  std::vector<bool> isSecond;
  Covariate view{"view", {}};
  Covariate expert{"expert", {}};

  void add(double seconds, int subject, int caseIndex, bool second) {
    times.push_back({std::min(seconds, kHorizon), seconds < kHorizon});
    subjects.push_back(subject);
    cases.push_back(caseIndex);
    isSecond.push_back(second);
    view.values.push_back(second ? 1 : 0);
    expert.values.push_back(isExpert(subject) ? 1 : 0);
  }
  static bool isExpert(int subject) { return subject % 3 == 0; }
  SurvivalData data() const { return {times, {view, expert}, {}, subjects}; }
};

/// Calls `seconds` for each trial of a full design.
Study studyOf(const std::function<double(int subject, int caseIndex, bool second)>& seconds) {
  Study study;
  for (int subject = 0; subject < kSubjects; ++subject) {
    for (int caseIndex = 0; caseIndex < kCases; ++caseIndex) {
      for (const bool second : {false, true}) {
        study.add(seconds(subject, caseIndex, second), subject, caseIndex, second);
      }
    }
  }
  return study;
}

/// Share of the studies in which `covers` says so; each draws numbers of its own.
double shareCovered(size_t studies, const std::function<bool(RandomNumbers&)>& covers) {
  std::vector<char> covered(studies);
  tbb::parallel_for(size_t{0}, studies, [&](size_t i) {
    RandomNumbers random(2026, i);
    covered[i] = covers(random) ? 1 : 0;
  });
  return static_cast<double>(std::accumulate(covered.begin(), covered.end(), 0)) / static_cast<double>(studies);
}

bool holds(const Estimate& estimate, double truth) {
  return estimate.lower <= truth && truth <= estimate.upper;
}

void expectCovered(const char* what, double share) {
  std::printf("%s: %.1f %%\n", what, 100 * share);
  EXPECT_GE(share, 0.93) << what;
  EXPECT_LE(share, 0.97) << what;
}

std::vector<double> normals(int count, double deviation, RandomNumbers& random) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    values.push_back(deviation * random.normal());
  }
  return values;
}

/// E min(T, horizon) of a log-normal T.
double limitedMean(double mean, double deviation) {
  const double z = (std::log(kHorizon) - mean) / deviation;
  return std::exp(mean + deviation * deviation / 2) * normalProbability(z - deviation) +
         kHorizon * (1 - normalProbability(z));
}

// Log seconds: cases of their own difficulty, subjects that are faster or slower and gain more or less from the second
// view.
constexpr double kMean = 2.7, kGain = -0.4;
constexpr double kOfSubjects = 0.35, kOfGains = 0.25, kOfTrials = 0.6;

double difficultyOf(int caseIndex) {
  return 0.12 * (caseIndex - 5.5);
}

Study logNormalStudy(const std::function<double(int caseIndex, bool second)>& shift, double ofGains,
                     RandomNumbers& random) {
  const std::vector<double> subjects = normals(kSubjects, kOfSubjects, random);
  const std::vector<double> gains = normals(kSubjects, ofGains, random);
  return studyOf([&](int subject, int caseIndex, bool second) {
    const auto i = static_cast<size_t>(subject);
    return std::exp(shift(caseIndex, second) + subjects[i] + (second ? gains[i] : 0) + kOfTrials * random.normal());
  });
}

double shiftOfCase(int caseIndex, bool second) {
  return kMean + difficultyOf(caseIndex) + (second ? kGain : 0);
}

/// Over the cases as they are.
double trueDifference() {
  double sum = 0;
  for (int caseIndex = 0; caseIndex < kCases; ++caseIndex) {
    sum += limitedMean(shiftOfCase(caseIndex, true),
                       std::sqrt(kOfSubjects * kOfSubjects + kOfGains * kOfGains + kOfTrials * kOfTrials)) -
           limitedMean(shiftOfCase(caseIndex, false), std::hypot(kOfSubjects, kOfTrials));
  }
  return sum / kCases;
}

TEST(Coverage, OfRestrictedMeanDifferencesBySubject) {
  const double truth = trueDifference();
  expectCovered("restricted mean difference, by subject", shareCovered(2000, [&](RandomNumbers& random) {
                  const Study study = logNormalStudy(shiftOfCase, kOfGains, random);
                  return holds(
                      restrictedMeanDifference(study.times, study.isSecond, kHorizon, study.subjects)->difference,
                      truth);
                }));
}

/// Hazards of a subject are multiplied by a number with the Laplace transform exp(-s^alpha), after which they are
/// proportional over all subjects too, with alpha times the log ratio (Hougaard 1986). Drawn as Chambers, Mallows and
/// Stuck 1976 do.
double stableFrailty(double alpha, RandomNumbers& random) {
  const double u = std::numbers::pi * random.uniform();
  const double w = -std::log(1 - random.uniform());
  return std::sin(alpha * u) / std::pow(std::sin(u), 1 / alpha) *
         std::pow(std::sin((1 - alpha) * u) / w, (1 - alpha) / alpha);
}

TEST(Coverage, OfClusteredCox) {
  const double alpha = 0.8, ofView = 0.6, ofExpert = 0.5;
  for (const size_t term : {size_t{0}, size_t{1}}) {
    const double truth = alpha * (term == 0 ? ofView : ofExpert);
    expectCovered(term == 0 ? "Cox, within subjects" : "Cox, between subjects",
                  shareCovered(1000, [&](RandomNumbers& random) {
                    std::vector<double> frailties;
                    for (int i = 0; i < kSubjects; ++i) {
                      frailties.push_back(stableFrailty(alpha, random));
                    }
                    const Study study = studyOf([&](int subject, int, bool second) {
                      const double log = (second ? ofView : 0) + (Study::isExpert(subject) ? ofExpert : 0);
                      const double rate = frailties[static_cast<size_t>(subject)] * std::exp(log) / 35;
                      return -std::log(1 - random.uniform()) / rate;
                    });
                    return holds(fitCox(study.data())->terms[term].logHazardRatio, truth);
                  }));
  }
}

TEST(Coverage, OfClusteredLogNormalTimes) {
  for (const size_t term : {size_t{0}, size_t{1}}) {
    expectCovered(term == 0 ? "log-normal, within subjects" : "log-normal, between subjects",
                  shareCovered(1000, [&](RandomNumbers& random) {
                    // Neither cases nor gains differ: over all trials, times are log-normal then.
                    const Study study =
                        logNormalStudy([](int, bool second) { return kMean + (second ? kGain : 0); }, 0, random);
                    return holds(fitLogNormal(study.data())->terms[term].logTimeRatio, term == 0 ? kGain : 0);
                  }));
  }
}

TEST(Coverage, OfTheBootstrapOfSubjects) {
  const double truth = trueDifference();
  std::atomic<int> coveredByBca = 0;
  const double byPercentile = shareCovered(1000, [&](RandomNumbers& random) {
    const Study study = logNormalStudy(shiftOfCase, kOfGains, random);
    const BootstrapPlan plan = {random.bits(), 600, ResampledUnits::kSubjects, 0.95};
    const BootstrapResult result =
        *bootstrapRestrictedMeanDifference(study.times, study.isSecond, kHorizon, study.subjects, {}, plan);
    coveredByBca += holds(*result.bca, truth) ? 1 : 0;
    return holds(result.percentile, truth);
  });
  expectCovered("bootstrap of subjects, percentile", byPercentile);
  expectCovered("bootstrap of subjects, BCa", coveredByBca / 1000.0);
}

TEST(Coverage, OfTheBootstrapOfSubjectsAndCases) {
  // Other cases might have been shown: their difficulty, and what the second view gains in them, are drawn too.
  const double ofCases = 0.4, ofCaseGains = 0.3;
  const double first = std::sqrt(kOfSubjects * kOfSubjects + kOfTrials * kOfTrials + ofCases * ofCases);
  const double truth =
      limitedMean(kMean + kGain, std::sqrt(first * first + kOfGains * kOfGains + ofCaseGains * ofCaseGains)) -
      limitedMean(kMean, first);
  expectCovered("bootstrap of subjects and cases, percentile", shareCovered(1000, [&](RandomNumbers& random) {
                  const std::vector<double> difficulties = normals(kCases, ofCases, random);
                  const std::vector<double> caseGains = normals(kCases, ofCaseGains, random);
                  const auto shift = [&](int caseIndex, bool second) {
                    const auto j = static_cast<size_t>(caseIndex);
                    return kMean + difficulties[j] + (second ? kGain + caseGains[j] : 0);
                  };
                  const Study study = logNormalStudy(shift, kOfGains, random);
                  const BootstrapPlan plan = {random.bits(), 600, ResampledUnits::kSubjectsAndCases, 0.95};
                  return holds(bootstrapRestrictedMeanDifference(study.times, study.isSecond, kHorizon, study.subjects,
                                                                 study.cases, plan)
                                   ->percentile,
                               truth);
                }));
}

}  // namespace
}  // namespace ocelli::test
