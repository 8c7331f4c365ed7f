#include "study/tasks/path_policy.h"

#include <gtest/gtest.h>

#include "study/agent/visibility_sensor.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

constexpr int64_t kPolicySecond = 1'000'000'000;
constexpr TrialScreen kPolicyScreen{240, 150, 60};

/// Watches the playback of a path trial; what it noticed, as the task writes turns, and the map that it chose.
struct Watched {
  std::string turns;
  int chosen = -1;
  std::string expected;
};
Watched watch(TrialView view, uint64_t seed, const HumanFactors& factors) {
  const auto block = test::readBlock(
      "path", R"({"maze": "small", "turns": 5, "least_seconds": 20, "most_seconds": 40, "cases": [{}]})");
  const TrialPlan plan = test::planOf("path", 0, view, seed);
  const auto run = block->start(plan, kPolicyScreen);
  const VisibilitySensor eye(kPolicyScreen);
  PathPolicy policy(Vision(factors, 5), seed);
  MotorModel motor(factors, Controls{}, 1);
  Watched watched;
  watched.expected = block->answerOf(plan);
  int64_t now = 0;
  for (int i = 0; i < 300; ++i, now += 3 * kPolicySecond / 10) {
    const TrialLayout layout = run->layout();
    policy.think(eye.look(layout, true), now, now + 3 * kPolicySecond / 10, motor);
    if (!layout.maps.empty()) {
      break;
    }
    for (int tick = 0; tick < 72; ++tick) {
      run->advance();
    }
  }
  for (const PathPolicy::Turn& turn : policy.turns()) {
    watched.turns += turn.side > 0 ? 'R' : 'L';
  }
  for (const TimedInput& input : motor.take(now + 60 * kPolicySecond)) {
    if (const auto* key = std::get_if<KeyEvent>(&input.event); key != nullptr && key->pressed) {
      run->handle(input.event);
    }
  }
  watched.chosen = run->outcome() && run->outcome()->correct ? 1 : 0;
  return watched;
}

TEST(PathPolicy, noticesTurnsByWhatItSeesAndChoosesTheirMap) {
  HumanFactors factors;
  factors.turnLapse = 0;
  factors.slip = 0;
  for (const TrialView view : kViews) {
    for (const uint64_t seed : {1u, 2u, 3u}) {
      const Watched watched = watch(view, seed, factors);
      EXPECT_EQ(watched.turns, watched.expected) << defaultConditions().nameOf(view) << seed;
      EXPECT_EQ(watched.chosen, 1);
    }
  }
}

TEST(PathPolicy, losesTurnsAsOftenAsItLapses) {
  HumanFactors factors;
  factors.turnLapse = 1;
  EXPECT_NE(watch(TrialView::kReference, 1, factors).turns, watch(TrialView::kReference, 1, factors).expected);
}

}  // namespace
}  // namespace ocelli
