#include "oc_core/constructor/split_depths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/random.h"

namespace ocelli {
namespace {

/// The mean of one split as its depth goes through the list.
std::vector<double> meansOf(SplitDepths& state, const std::vector<double>& depths) {
  std::vector<double> means;
  for (const double depth : depths) {
    const std::vector<SplitDepth> now{{"left|ahead", depth}};
    means.push_back(state.next(now).front().depth);
  }
  return means;
}

TEST(SplitDepths, theFirstFrameIsAsItIs) {
  SplitDepths state;
  EXPECT_EQ(meansOf(state, {7}), std::vector<double>{7});
}

TEST(SplitDepths, anAbruptChangeIsSpreadOver30Frames) {
  SplitDepths state;
  std::vector<double> depths(30, 0.0);
  depths.resize(70, 60.0);
  const std::vector<double> means = meansOf(state, depths);
  EXPECT_EQ(means[29], 0);
  for (size_t i = 0; i < 30; ++i) {
    EXPECT_NEAR(means[30 + i], 2.0 * static_cast<double>(i + 1), 1e-12);  // 60 / 30 a frame
  }
  EXPECT_EQ(means[69], 60);
}

TEST(SplitDepths, noStepIsMoreThanTheRangeOverTheFrames) {
  Random random(3);
  SplitDepths state;
  std::vector<double> depths;
  for (int i = 0; i < 500; ++i) {
    depths.push_back(random.below(2) == 0 ? 0.0 : 90.0);  // a line that comes and goes abruptly
  }
  const std::vector<double> means = meansOf(state, depths);
  for (size_t i = 30; i < means.size(); ++i) {
    EXPECT_LE(std::abs(means[i] - means[i - 1]), 90.0 / 30 + 1e-12);
  }
}

TEST(SplitDepths, aSplitThatComesUpOpensFromZero) {
  SplitDepths state;
  for (int i = 0; i < 40; ++i) {
    state.next({});
  }
  const std::vector<double> means = meansOf(state, std::vector<double>(30, 15.0));
  EXPECT_NEAR(means.front(), 0.5, 1e-12);
  EXPECT_NEAR(means.back(), 15, 1e-12);
  for (int i = 0; i < 10; ++i) {
    state.next({});
  }
  EXPECT_NEAR(state.depth("left|ahead"), 10, 1e-12);  // 20 of 30 frames have it
  EXPECT_EQ(state.depth("ahead|right"), 0);
}

TEST(SplitDepths, splitsDoNotMixAndKeepTheirOrder) {
  SplitDepths state(2);
  const std::vector<SplitDepth> one{{"b", 1}, {"a", 10}};
  const std::vector<SplitDepth> two{{"b", 3}, {"a", 20}};
  state.next(one);
  EXPECT_EQ(state.next(two), (std::vector<SplitDepth>{{"b", 2}, {"a", 15}}));
}

TEST(SplitDepths, afterAJumpOfTheEyeTheNextFrameIsTheFirst) {
  SplitDepths state;
  meansOf(state, {1, 2, 3});
  state.clear();
  EXPECT_EQ(meansOf(state, {50}), std::vector<double>{50});
}

}  // namespace
}  // namespace ocelli
