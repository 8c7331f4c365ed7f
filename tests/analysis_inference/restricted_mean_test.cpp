#include "analysis/inference/restricted_mean.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/random_numbers.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

std::vector<bool> findViews() {
  std::vector<bool> views;
  for (const double view : golden("find/view")) {
    views.push_back(view == 1);
  }
  return views;
}

TEST(RestrictedMean, IsThatOfSurvfit) {
  const RestrictedMean lung = *restrictedMean(goldenTimes("lung"), 500);
  expectGolden({lung.mean.value, lung.mean.standardError}, "rmean/lung500", kClosedForm);
  const RestrictedMeanDifference find = *restrictedMeanDifference(goldenTimes("find"), findViews(), 60);
  expectGolden({find.first.mean.value, find.first.mean.standardError}, "rmean/find0", kClosedForm);
  expectGolden({find.second.mean.value, find.second.mean.standardError}, "rmean/find1", kClosedForm);
  EXPECT_DOUBLE_EQ(find.difference.standardError,
                   std::hypot(find.first.mean.standardError, find.second.mean.standardError));
}

TEST(RestrictedMean, DiffersBySubjectsWithTheSummedResidualsOfSurvfit) {
  const RestrictedMeanDifference find =
      *restrictedMeanDifference(goldenTimes("find"), findViews(), 60, goldenClusters("find"));
  expectGolden({find.difference.value, find.difference.standardError}, "rmean/clustered", kClosedForm);
  EXPECT_EQ(find.difference.degreesOfFreedom, 19);
  EXPECT_EQ(find.first.clusters, 20u);
  EXPECT_EQ(find.first.trials, 120u);
}

TEST(RestrictedMean, IsTheMeanWhereNothingIsCensoredBeforeTheHorizon) {
  // Time-outs at the horizon are worth the horizon.
  const RestrictedMean all = *restrictedMean({{10, true}, {20, true}, {60, false}, {30, true}}, 60);
  EXPECT_DOUBLE_EQ(all.mean.value, 30);
  EXPECT_EQ(all.events, 3u);
  // With each trial a cluster of its own: the standard error of a mean.
  const RestrictedMean clustered = *restrictedMean({{10, true}, {20, true}, {60, false}, {30, true}}, 60, {1, 2, 3, 4});
  const double deviation = std::sqrt((20.0 * 20 + 10 * 10 + 30 * 30) / 3);
  EXPECT_NEAR(clustered.mean.standardError, deviation / 2, 1e-12);
}

/// The slow reference: how the area changes with the weight of a trial, by weighing it a little more.
double weighedArea(const std::vector<SurvivalTime>& times, double horizon, size_t heavier, double weight) {
  double area = 0, survival = 1, from = 0;
  for (const RiskSet& set : riskSets(times)) {
    if (set.seconds >= horizon) {
      break;
    }
    double atRisk = 0, events = 0;
    for (size_t i = 0; i < times.size(); ++i) {
      const double w = i == heavier ? weight : 1;
      atRisk += times[i].seconds >= set.seconds ? w : 0;
      events += times[i].seconds == set.seconds && times[i].observed ? w : 0;
    }
    area += survival * (set.seconds - from);
    survival *= 1 - events / atRisk;
    from = set.seconds;
  }
  return area + survival * (horizon - from);
}

TEST(RestrictedMean, HasTheClusteredErrorOfWeighingTrials) {
  RandomNumbers random(4);
  std::vector<SurvivalTime> times;
  std::vector<int> clusters;
  for (int i = 0; i < 40; ++i) {
    times.push_back({static_cast<double>(1 + random.below(20)), random.uniform() < 0.7});
    clusters.push_back(i % 8);
  }
  times.push_back({20, false});
  clusters.push_back(0);
  std::vector<double> sums(8);
  const double step = 1e-5;
  for (size_t i = 0; i < times.size(); ++i) {
    sums[static_cast<size_t>(clusters[i])] +=
        (weighedArea(times, 15, i, 1 + step) - weighedArea(times, 15, i, 1 - step)) / (2 * step);
  }
  double squares = 0;
  for (const double sum : sums) {
    squares += sum * sum;
  }
  const RestrictedMean mean = *restrictedMean(times, 15, clusters);
  EXPECT_NEAR(mean.mean.value, weighedArea(times, 15, 0, 1), 1e-12);
  EXPECT_NEAR(mean.mean.standardError, std::sqrt(squares * 8 / 7), 1e-7);  // of the differences
}

TEST(RestrictedMean, SaysWhatItLacks) {
  const auto reason = [](const std::vector<SurvivalTime>& times, const std::vector<int>& clusters = {}) {
    return restrictedMean(times, 60, clusters).reason();
  };
  EXPECT_EQ(reason({}), "there are no trials");
  EXPECT_EQ(reason({{60, false}, {60, false}}), "none of 2 trials ended by itself before 60 s");
  EXPECT_EQ(reason({{10, true}, {30, false}}),
            "no trial was watched for longer than 30 s, so the curve is not known until 60 s");
  EXPECT_EQ(reason({{10, true}, {10, true}}), "all 2 trials ended at the same moment");
  EXPECT_EQ(reason({{10, true}, {20, true}}, {1, 1}),
            "all trials belong to one subject, so subjects cannot be compared");
  EXPECT_EQ(reason({{10, true}, {20, true}, {10, true}, {20, true}}, {1, 1, 2, 2}), "all subjects have the same mean");
  EXPECT_EQ(restrictedMeanDifference({{10, true}, {20, true}}, {false, false}, 60).reason(),
            "in the second group, there are no trials");
  EXPECT_THROW(restrictedMean({{-1, true}}, 60), InputError);
  EXPECT_THROW(restrictedMean({{1, true}}, 0), InputError);
}

}  // namespace
}  // namespace ocelli::test
