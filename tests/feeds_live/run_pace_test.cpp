#include "oc_core/feeds_live/run_pace.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

double between(RunPace::Clock::time_point from, RunPace::Clock::time_point to) {
  return Milliseconds(to - from).count();
}

TEST(RunPace, goesNoFasterThanThePlace) {
  RunPace pace;
  const auto began = RunPace::Clock::now();
  EXPECT_EQ(pace.due(3.0, began), began) << "the first image at once";
  EXPECT_NEAR(between(began, pace.due(3.1, began)), 100, 1e-3);
  EXPECT_NEAR(between(began, pace.due(3.2, began + std::chrono::milliseconds(130))), 200, 1e-3);
}

TEST(RunPace, doesNotCatchUpWithAPause) {
  RunPace pace;
  const auto began = RunPace::Clock::now();
  pace.due(0, began);
  const auto later = began + std::chrono::seconds(60);
  EXPECT_LE(pace.due(0.1, later), later);
  const auto next = pace.due(1.1, later);
  EXPECT_GT(between(later, next), 800) << "not 59 s of images at once";
  EXPECT_LT(between(later, next), 1001);
}

TEST(RunPace, anImageThatTakesLongerLeavesNoGap) {
  RunPace pace;
  const auto began = RunPace::Clock::now();
  pace.due(0, began);
  pace.due(0.1, began + std::chrono::milliseconds(180));
  EXPECT_NEAR(between(began, pace.due(0.2, began + std::chrono::milliseconds(181))), 200, 1e-3);
}

}  // namespace
}  // namespace ocelli
