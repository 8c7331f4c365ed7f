#include "analysis/inference/holm.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "tests/analysis_inference/golden.h"

namespace ocelli::test {
namespace {

TEST(Holm, IsPAdjust) {
  expectGolden(holmAdjusted(golden("holm/p")), "holm/adjusted", kClosedForm);
}

TEST(Holm, AdjustsEachFamilyForItself) {
  std::vector<FamilyTest> tests;
  for (size_t i = 0; i < 6; ++i) {
    tests.push_back({i < 3 ? "find" : "count", golden("holm/p")[i]});
  }
  expectGolden(holmAdjusted(tests), "holm/families", kClosedForm);
}

TEST(Holm, CountsWhatCouldNotBeTested) {
  const std::vector<double> adjusted = holmAdjusted(std::vector<double>{0.02, NAN, 0.03});
  EXPECT_DOUBLE_EQ(adjusted[0], 0.06);
  EXPECT_TRUE(std::isnan(adjusted[1]));
  EXPECT_DOUBLE_EQ(adjusted[2], 0.06);
  EXPECT_DOUBLE_EQ(holmAdjusted(std::vector<double>{NAN, 0.042})[1], 0.084);
  EXPECT_THROW(holmAdjusted(std::vector<double>{1.5}), InputError);
}

}  // namespace
}  // namespace ocelli::test
