#include "analysis/inference/permutation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/base/random_numbers.h"

namespace ocelli::test {
namespace {

/// The slow reference.
double shareOfTurns(const std::vector<double>& means) {
  double sum = 0;
  for (const double mean : means) {
    sum += mean;
  }
  int count = 0;
  const int turns = 1 << means.size();
  for (int turn = 0; turn < turns; ++turn) {
    double turned = 0;
    for (size_t i = 0; i < means.size(); ++i) {
      turned += (turn >> i & 1) != 0 ? -means[i] : means[i];
    }
    count += std::abs(turned) >= std::abs(sum) - 1e-9 ? 1 : 0;
  }
  return static_cast<double>(count) / turns;
}

TEST(SignFlip, TriesEveryTurn) {
  RandomNumbers random(9);
  std::vector<double> means;
  std::vector<SubjectDifference> differences;
  for (int subject = 0; subject < 11; ++subject) {
    means.push_back(0.4 + random.normal());
    differences.push_back({subject, means.back() - 1});
    differences.push_back({subject, means.back() + 1});
  }
  const SignFlipTest test = *signFlipTest(differences);
  EXPECT_TRUE(test.exact);
  EXPECT_EQ(test.turns, 2048u);
  EXPECT_EQ(test.subjects, 11u);
  EXPECT_DOUBLE_EQ(test.pValue, shareOfTurns(means));
}

TEST(SignFlip, CountsEqualSumsAsAtLeastAsFar) {
  EXPECT_DOUBLE_EQ(signFlipTest({{1, 0.1}, {2, 0.2}, {3, 0.3}})->pValue, 2.0 / 8);
  // Turned at 3: 0.1 + 0.2 - 0.3 is 0 and 0.1 + 0.2 + 0.3 is twice that of 3 alone.
  EXPECT_DOUBLE_EQ(signFlipTest({{1, 0.1}, {2, 0.2}, {3, -0.3}})->pValue, 1);
}

TEST(SignFlip, DrawsTurnsOfManySubjects) {
  RandomNumbers random(10);
  std::vector<SubjectDifference> differences;
  for (int subject = 0; subject < 100; ++subject) {
    differences.push_back({subject, 0.2 + random.normal()});
  }
  const SignFlipTest test = *signFlipTest(differences, 3, 20000);
  EXPECT_FALSE(test.exact);
  double squares = 0;
  for (const SubjectDifference& each : differences) {
    squares += each.difference * each.difference;
  }
  // The sum of turns is nearly normal; 4.5 standard deviations of the drawn share, and 0.002 for "nearly".
  const double normal = std::erfc(std::abs(100 * test.mean) / std::sqrt(2 * squares));
  EXPECT_NEAR(test.pValue, normal, 4.5 * std::sqrt(normal * (1 - normal) / 20000) + 0.002);
  EXPECT_EQ(test.pValue, signFlipTest(differences, 3, 20000)->pValue);
  EXPECT_NE(test.pValue, signFlipTest(differences, 4, 20000)->pValue);
}

TEST(SignFlip, SaysWhatItLacks) {
  EXPECT_EQ(signFlipTest({{1, 2}, {1, 3}}).reason(), "there are 1 subjects, and 2 are needed");
  EXPECT_EQ(signFlipTest({{1, 0}, {2, 0}}).reason(), "all differences are 0");
}

}  // namespace
}  // namespace ocelli::test
