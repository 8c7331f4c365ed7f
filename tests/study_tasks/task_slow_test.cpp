// What takes millions of ticks, poses or events.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/study_task/maze_walks.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

TEST(TasksSlow, aMillionStepsStayClearOfWalls) {
  test::checkRandomWalks(100, 10000);
}

TEST(TasksSlow, portalCamerasTakeAllPoses) {
  constexpr int kPoses = 2000;
  const int64_t refused = test::refusedPoses(200, kPoses);
  std::printf("%lld of %d poses refused\n", static_cast<long long>(refused), 200 * kPoses);
  EXPECT_EQ(refused, 0);
}

TEST(TasksSlow, aMillionEventsAreBorne) {
  const TrialScreen screen{640, 480, 60};
  for (const test::TaskExample& example : test::taskExamples()) {
    const auto block = test::readBlock(example.task, example.json);
    const auto cases = static_cast<size_t>(block->caseCount());
    Random random(1);
    std::unique_ptr<TrialRun> run;
    int trials = 0;
    int64_t tick = 0;
    for (int i = 0; i < 200'000; ++i) {
      if (!run || run->outcome()) {
        const TrialView view = kViews[random.below(2)];
        run = block->start(test::planOf(example.task, static_cast<int>(random.below(cases)), view, random.next()),
                           screen);
        ++trials;
        tick = 0;
      }
      run->handle(test::randomInput(random, screen));
      if (random.below(3) != 0) {
        run->advance();
        ++tick;
      }
      if (random.below(8) == 0) {
        run->frameShown(tick);
      }
      if (random.below(100) == 0) {
        run->layout();
      }
    }
    EXPECT_GT(trials, 10);
  }
}

}  // namespace
}  // namespace ocelli
