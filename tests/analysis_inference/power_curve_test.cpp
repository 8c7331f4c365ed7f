#include "analysis/inference/power_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli {
namespace {

using Place = NeededSubjects::Place;

std::vector<PowerPoint> pointsOf(const std::vector<int>& subjects, const std::vector<int>& found, int studies) {
  std::vector<PowerPoint> points;
  for (size_t i = 0; i < subjects.size(); ++i) {
    points.push_back({subjects[i], {found[i], studies}});
  }
  return points;
}

TEST(SubjectsForPower, AreInterpolatedBetweenSizes) {
  const SubjectsForPower needed = subjectsForPower(pointsOf({10, 20, 40}, {300, 700, 900}, 1000), 0.8);
  EXPECT_EQ(needed.estimate.place, Place::kAbout);
  EXPECT_DOUBLE_EQ(needed.estimate.subjects, 30);
  EXPECT_EQ(describe(needed.estimate), "about 30");
  EXPECT_EQ(needed.fewest.place, Place::kAbout);
  EXPECT_LT(needed.fewest.subjects, 30);
  EXPECT_GT(needed.fewest.subjects, 20);
  EXPECT_GT(needed.most.subjects, 30);
  EXPECT_LT(needed.most.subjects, 40);
}

TEST(SubjectsForPower, AreWholeSubjectsRoundedUp) {
  EXPECT_EQ(describe({Place::kAbout, 30.01}), "about 31");
  EXPECT_EQ(describe({Place::kAbout, 30}), "about 30");
}

TEST(SubjectsForPower, NeverReachedIsSaidPlainly) {
  const SubjectsForPower needed = subjectsForPower(pointsOf({10, 20}, {10, 20}, 100), 0.8);
  EXPECT_EQ(needed.estimate.place, Place::kMoreThan);
  EXPECT_EQ(needed.fewest.place, Place::kMoreThan);
  EXPECT_EQ(describe(needed.estimate), "not reached with 20");
}

TEST(SubjectsForPower, OfTheSmallestSizeAreAnUpperBound) {
  const SubjectsForPower needed = subjectsForPower(pointsOf({10, 20}, {99, 100}, 100), 0.8);
  EXPECT_EQ(describe(needed.estimate), "at most 10");
  EXPECT_EQ(needed.most.place, Place::kAtMost);
}

TEST(SubjectsForPower, ChanceThatIsTooLargeLeavesTheLargestOpen) {
  // 17 of 20 is above 0.8, but so few studies do not show it.
  const SubjectsForPower needed = subjectsForPower(pointsOf({10, 20}, {8, 17}, 20), 0.8);
  EXPECT_EQ(needed.estimate.place, Place::kAbout);
  EXPECT_EQ(needed.most.place, Place::kMoreThan);
}

TEST(SubjectsForPower, SharesThatFallArePooled) {
  // 0.82 at 20 and 0.74 at 30 are 0.78 together: the chance peak is not taken for enough.
  const SubjectsForPower needed = subjectsForPower(pointsOf({10, 20, 30, 40}, {50, 82, 74, 90}, 100), 0.8);
  EXPECT_EQ(needed.estimate.place, Place::kAbout);
  EXPECT_NEAR(needed.estimate.subjects, 30 + 10 * (0.8 - 0.78) / (0.9 - 0.78), 1e-9);
}

TEST(SubjectsForPower, RejectWhatIsNoCurve) {
  EXPECT_THROW(subjectsForPower({}, 0.8), InputError);
  EXPECT_THROW(subjectsForPower(pointsOf({20, 10}, {1, 2}, 10), 0.8), InputError);
  EXPECT_THROW(subjectsForPower(pointsOf({10, 20}, {0, 0}, 0), 0.8), InputError);
  EXPECT_THROW(subjectsForPower(pointsOf({10, 20}, {1, 2}, 10), 1), InputError);
  EXPECT_THROW(subjectsForPower(pointsOf({10, 20}, {1, 2}, 10), std::nan("")), InputError);
}

// The power of a two-sided z test of a mean of 0.5 with standard deviation 1: 80 % need (1.960 + 0.842)^2 / 0.25 = 31.4
// subjects. The interval has to hold that in 95 % of all simulations at least.
TEST(SubjectsForPower, IntervalsCoverTheKnownNumber) {
  const auto below = [](double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; };
  constexpr double kTrue = 31.396;
  int covered = 0;
  double sum = 0;
  constexpr int kRepeats = 1000;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    RandomNumbers numbers(7, static_cast<uint64_t>(repeat));
    std::vector<PowerPoint> points;
    for (const int subjects : {10, 20, 30, 40, 50}) {
      const double shift = 0.5 * std::sqrt(subjects);
      const double power = below(shift - 1.95996) + below(-shift - 1.95996);
      PowerPoint point{subjects, {0, 200}};
      for (int study = 0; study < 200; ++study) {
        point.found.successes += numbers.uniform() < power ? 1 : 0;
      }
      points.push_back(point);
    }
    const SubjectsForPower needed = subjectsForPower(points, 0.8);
    const bool aboveFewest = needed.fewest.place != Place::kMoreThan && needed.fewest.subjects <= kTrue;
    const bool belowMost = needed.most.place == Place::kMoreThan || needed.most.subjects >= kTrue;
    covered += aboveFewest && belowMost ? 1 : 0;
    sum += needed.estimate.subjects;
  }
  EXPECT_GE(covered, 0.94 * kRepeats) << "0.95 less about 1.5 standard errors of a thousand repeats";
  EXPECT_NEAR(sum / kRepeats, kTrue, 1) << "lines are not quite the curve, which bends";
}

}  // namespace
}  // namespace ocelli
