#include "study/replay/trial_replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/study_replay/made_log.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

Image<Rgb8> views(const TrialLayout& layout, const TrialScreen& screen) {
  return viewsOf(layout, screen, rasterizeStudy);
}

class TrialReplay : public testing::TestWithParam<test::TaskExample> {
 protected:
  std::shared_ptr<const TaskBlock> block = test::readBlock(GetParam().task, GetParam().json);
};

TEST_P(TrialReplay, isTheSameAsItsLog) {
  for (const uint64_t seed : {1u, 2u}) {
    const TrialLog log = test::madeLog(*block, GetParam(), seed);
    size_t shown = 0;
    ReplayOptions options;
    options.views = views;
    options.onFrame = [&](const FrameRecord&, const TrialRun&) { ++shown; };
    const ReplayVerdict verdict = replayTrial(*block, log, options);
    EXPECT_TRUE(verdict.isSame()) << verdict.firstDifference;
    EXPECT_EQ(verdict.frames, static_cast<int64_t>(log.frames.size()));
    EXPECT_EQ(shown, log.frames.size());
    EXPECT_EQ(verdict.hashes, static_cast<int64_t>(std::min<size_t>(log.frames.size(), test::kHashedFrames)));
  }
}

TEST_P(TrialReplay, ofATrialThatWasStoppedEndsThere) {
  const TrialLog log = test::madeLog(*block, GetParam(), 2, 60);
  ASSERT_EQ(log.record.ending, TrialEnding::kAborted);
  EXPECT_TRUE(replayTrial(*block, log).isSame());
}

TEST_P(TrialReplay, catchesAnotherPoseInOneFrame) {
  TrialLog log = test::madeLog(*block, GetParam(), 2);
  FrameRecord& frame = log.frames[log.frames.size() / 2];
  frame.pose.x = std::nextafter(frame.pose.x, 1e9);
  const ReplayVerdict verdict = replayTrial(*block, log);
  EXPECT_FALSE(verdict.isSame());
  EXPECT_EQ(verdict.samePoses, verdict.frames - 1);
  EXPECT_THAT(verdict.firstDifference, HasSubstr("frame"));
}

TEST_P(TrialReplay, catchesAnotherPixel) {
  TrialLog log = test::madeLog(*block, GetParam(), 2);
  log.frames[3].pixelHash = *log.frames[3].pixelHash + 1;
  ReplayOptions options;
  EXPECT_TRUE(replayTrial(*block, log, options).isSame()) << "no one looks at pixels";
  options.views = views;
  const ReplayVerdict verdict = replayTrial(*block, log, options);
  EXPECT_EQ(verdict.sameHashes, verdict.hashes - 1);
  EXPECT_FALSE(verdict.isSame());
}

TEST_P(TrialReplay, catchesAnotherOutcome) {
  TrialLog log = test::madeLog(*block, GetParam(), 2);
  ++log.record.outcome.responseTicks;
  EXPECT_FALSE(replayTrial(*block, log).isSame());
}

INSTANTIATE_TEST_SUITE_P(Tasks, TrialReplay, testing::ValuesIn(test::taskExamples()),
                         [](const auto& example) { return example.param.name; });

TEST(TrialReplayOfASearch, catchesInputThatIsLeftOut) {
  const test::TaskExample& example = test::taskExamples().front();
  const auto block = test::readBlock(example.task, example.json);
  TrialLog log;
  log.record.plan = test::planOf("find", 0, TrialView::kReference);
  log.record.screen = {200, 125, 60};
  const auto run = block->start(log.record.plan, log.record.screen);
  log.inputs = {{0, 10, test::press(Key::kE)}, {0, 50, test::release(Key::kE)}};
  size_t next = 0;
  for (int64_t tick = 0; !run->outcome(); ++tick) {
    for (; next < log.inputs.size() && log.inputs[next].tick == tick; ++next) {
      run->handle(log.inputs[next].event);
    }
    if (tick % 4 == 0) {
      log.frames.push_back({tick / 4, tick, test::shownAt(tick), run->pose(), {}});
      run->frameShown(ticksBetween(0, test::shownAt(tick)));
    }
    run->advance();
  }
  log.record.outcome = *run->outcome();
  ASSERT_TRUE(replayTrial(*block, log).isSame());
  log.inputs.pop_back();
  const ReplayVerdict verdict = replayTrial(*block, log);
  EXPECT_FALSE(verdict.isSame());
  EXPECT_THAT(verdict.firstDifference, HasSubstr("frame 13 at tick 52"));
}

}  // namespace
}  // namespace ocelli
