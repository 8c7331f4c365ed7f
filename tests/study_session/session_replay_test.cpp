// The log of a trial gives it again, bit by bit.
#include <gtest/gtest.h>

#include "tests/study_session/session_harness.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

using test::FakeSink;
using test::SessionRun;

Protocol protocolOf(const test::TaskExample& example) {
  Protocol protocol;
  protocol.name = "one-block";
  ProtocolBlock block;
  block.name = "only";
  block.title = "Only";
  block.taskName = example.task;
  block.task = test::readBlock(example.task, example.json);
  block.views = ViewsOfCases::kAll;
  protocol.blocks = {block};
  return protocol;
}

/// As session_flow.h says: inputs of a tick, its frames, then the tick passes.
void replay(const TaskBlock& block, const TrialRecord& record, const std::vector<FrameRecord>& frames,
            const std::vector<InputRecord>& inputs) {
  const auto run = block.start(record.plan, record.screen);
  size_t input = 0;
  size_t frame = 0;
  const bool completed = record.ending == TrialEnding::kCompleted;
  for (int64_t tick = 0; input < inputs.size() || frame < frames.size() || (completed && !run->outcome()); ++tick) {
    for (; input < inputs.size() && inputs[input].tick == tick; ++input) {
      run->handle(inputs[input].event);
    }
    for (; frame < frames.size() && frames[frame].tick == tick; ++frame) {
      EXPECT_TRUE(run->pose() == frames[frame].pose) << "frame " << frame;
      run->frameShown();
    }
    ASSERT_LT(tick, 100 * kTicksPerSecond);
    run->advance();
  }
  if (completed) {
    EXPECT_TRUE(run->outcome() == record.outcome);
  }
}

class SessionReplay : public testing::TestWithParam<test::TaskExample> {};

TEST_P(SessionReplay, reproducesPosesAndOutcomes) {
  const Protocol protocol = protocolOf(GetParam());
  const SessionSchedule schedule = scheduleOf(protocol, 1, 1, 5);
  size_t moved = 0;
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    FakeSink sink;
    SessionRun run(protocol, schedule, sink);
    // Random keys, late events, frames of random length, some of them two in a tick.
    for (int i = 0; !run.flow.isOver() && i < 20000; ++i) {
      if (!run.inTrial()) {
        run.tap(Key::kEnter);
        continue;
      }
      for (size_t k = random.below(3); k > 0; --k) {
        InputEvent event = test::randomInput(random, {640, 480, 60});
        if (auto* key = std::get_if<KeyEvent>(&event)) {
          // Most keys mean nothing: choose among those that do.
          const std::array keys{Key::kW, Key::kA,  Key::kS,    Key::kD,    Key::kQ,
                                Key::kE, Key::kUp, Key::kLeft, Key::kSpace};
          key->key = keys[random.below(keys.size())];
        }
        run.flow.handle({event, run.now + static_cast<int64_t>(random.below(20'000'000)) - 5'000'000});
        run.now += static_cast<int64_t>(random.below(3'000'000));
      }
      run.frame(random.below(10) == 0 ? 10'000 : static_cast<int64_t>(1'000'000 + random.below(60'000'000)));
      if (random.below(400) == 0) {
        run.flow.redo();
      }
    }
    ASSERT_TRUE(run.flow.isOver());
    for (const test::TrialEnds& ends : sink.all<test::TrialEnds>()) {
      const std::vector<FrameRecord> frames = sink.framesOf(ends.number);
      replay(*protocol.blocks[0].task, ends.record, frames, sink.inputsOf(ends.number));
      moved += !frames.empty() && frames.front().pose != frames.back().pose ? 1 : 0;
    }
  }
  if (GetParam().walks) {
    EXPECT_GT(moved, 10u);
  } else {
    EXPECT_EQ(moved, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Tasks, SessionReplay, testing::ValuesIn(test::taskExamples()),
                         [](const auto& example) { return example.param.name; });

TEST(SessionExposure, isCountedInFramesHoweverLongTheyLast) {
  const Protocol protocol = protocolOf(test::taskExamples()[2]);
  const SessionSchedule schedule = scheduleOf(protocol, 0, 1, 5);
  FakeSink sink;
  SessionRun run(protocol, schedule, sink);
  Random random(9);
  while (!run.flow.isOver()) {
    if (run.inTrial()) {
      run.frame(random.below(5) == 0 ? 3 * test::kFrameNanoseconds : test::kFrameNanoseconds);
    } else {
      run.tap(Key::kEnter);
    }
  }
  const auto ends = sink.all<test::TrialEnds>();
  ASSERT_EQ(ends.size(), 4u);
  for (const test::TrialEnds& end : ends) {
    EXPECT_EQ(end.record.outcome.exposureFrames, std::lround(*end.record.info.exposureSeconds * 60));
    EXPECT_GT(end.record.timing.dropped, 0);
  }
}

}  // namespace
}  // namespace ocelli
