// Staircases in sessions: levels that follow the answers, and sessions that are cut off in the middle of them.
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "study/protocol/leveled_block.h"
#include "study/protocol/up_down.h"
#include "tests/study_session/session_harness.h"

namespace ocelli {
namespace {

using test::FakeSink;
using test::SessionRun;

/// The small study, with a staircase over five digits in its second block.
Protocol stairs() {
  Protocol protocol = test::smallProtocol();
  ProtocolBlock& block = protocol.blocks[1];
  auto staircase = std::make_shared<BlockStaircase>();
  staircase->levels = {1, 2, 4, 8, 16};
  staircase->cases = {2, 0, 1, 4, 3};
  staircase->trials = 8;
  staircase->rule = std::make_shared<UpDown>(staircase->levels, UpDownOptions{.rightInARow = 1, .firstStep = 1});
  block.staircase = staircase;
  block.task = leveledBlock(test::digitTask(5), staircase->levelsByCase());
  return protocol;
}

/// The one that is answered always: right for digit 2 alone.
constexpr Key kAnswer = Key::k2;

/// Of the completed trials of the staircase, in order: "3 ppc right".
std::vector<std::string> shownIn(const Protocol& protocol, std::span<const test::SinkCall> calls) {
  std::vector<std::string> shown;
  for (const test::SinkCall& call : calls) {
    const auto* ends = std::get_if<test::TrialEnds>(&call);
    if (ends != nullptr && ends->record.plan.block == 1 && ends->record.ending == TrialEnding::kCompleted) {
      const TrialRecord& record = ends->record;
      EXPECT_EQ(record.outcome.measures.at(kLevelMeasure), record.info.level);
      shown.push_back(record.info.label + " " + protocol.nameOf(record.plan.view) +
                      (record.outcome.correct ? " right" : " wrong"));
    }
  }
  return shown;
}

struct Whole {
  Protocol protocol = stairs();
  SessionSchedule schedule = test::smallSchedule(protocol);
  FakeSink sink;

  Whole() {
    SessionRun run(protocol, schedule, sink);
    go(run);
  }
  static void go(SessionRun& run) {
    // In the first block right answers, which its practice asks for.
    run.goOn([&] { return run.inTrial() && run.flow.trialPlan()->block == 1; });
    run.answer = kAnswer;
    run.goOn();
  }
};

TEST(SessionStaircase, EachConditionStaysAtTheTopOfItsStaircaseWhereAllIsWrong) {
  const Whole whole;
  const std::vector<std::string> shown = shownIn(whole.protocol, whole.sink.calls);
  ASSERT_EQ(shown.size(), 16u);
  for (const char* view : {"ppc", "gc"}) {
    std::vector<std::string> labels;
    for (const std::string& each : shown) {
      const size_t at = each.find(std::string(" ") + view + " ");
      if (at != std::string::npos) {
        labels.push_back(each.substr(0, at));
      }
    }
    // The greatest level is digit 4, which is answered wrong, as all but digit 2 are: it stays there.
    EXPECT_EQ(labels, std::vector<std::string>(8, "digit 4")) << view;
  }
  int events = 0;
  for (const EventRecord& event : whole.sink.all<EventRecord>()) {
    events += event.what == "staircase" ? 1 : 0;
  }
  EXPECT_EQ(events, 2);
}

TEST(SessionStaircase, GoesOnAtTheSameLevelsWhereverTheSessionWasCut) {
  for (const ResumePolicy policy : {ResumePolicy::kNextTrial, ResumePolicy::kRestartBlock}) {
    Protocol protocol = stairs();
    protocol.resume = policy;
    const SessionSchedule schedule = test::smallSchedule(protocol);
    // Wrong in some trials, by their seeds, whatever they show: the levels go down and up.
    const auto go = [&](SessionRun& run) {
      while (!run.flow.isOver()) {
        const auto plan = run.flow.trialPlan();
        const bool wrong = plan && plan->block == 1 && plan->seed % 3 == 0;
        run.answer = wrong ? std::optional(Key::k9) : std::nullopt;
        bool stepped = false;
        run.goOn([&] { return std::exchange(stepped, true); });
      }
    };
    FakeSink whole;
    {
      SessionRun run(protocol, schedule, whole);
      go(run);
    }
    const std::vector<std::string> expected = shownIn(protocol, whole.calls);
    ASSERT_EQ(expected.size(), 16u);
    EXPECT_GT(std::set<std::string>(expected.begin(), expected.end()).size(), 5u) << "levels change";
    for (size_t cut = 0; cut + 1 < whole.calls.size(); ++cut) {
      const std::span<const test::SinkCall> before(whole.calls.data(), cut);
      FakeSink after;
      SessionRun run(protocol, schedule, after, test::doneAfter(before, schedule, protocol));
      go(run);
      std::vector<std::string> shown = shownIn(protocol, before);
      if (policy == ResumePolicy::kRestartBlock && shown.size() < expected.size()) {
        shown.clear();
      }
      const std::vector<std::string> rest = shownIn(protocol, after.calls);
      shown.insert(shown.end(), rest.begin(), rest.end());
      EXPECT_EQ(shown, expected) << "cut after " << cut;
    }
  }
}

TEST(SessionStaircase, ATrialThatIsDoneAgainShowsItsCaseAgainAndItsLastAnswerCounts) {
  const Protocol protocol = stairs();
  const SessionSchedule schedule = test::smallSchedule(protocol);
  FakeSink sink;
  SessionRun run(protocol, schedule, sink);
  const auto nextTrial = [&] {
    run.answer.reset();
    run.goOn([&] { return run.inTrial() && run.flow.trialPlan()->block == 1; });
    return *run.flow.trialPlan();
  };
  const TrialPlan first = nextTrial();
  run.answer = Key::k9;
  run.answerTrial();
  ASSERT_TRUE(run.flow.redo());
  const TrialPlan again = nextTrial();
  EXPECT_EQ(again, first);
  run.answer.reset();
  run.answerTrial();  // right now: its condition goes down
  TrialPlan next = nextTrial();
  while (next.view != first.view) {
    run.answerTrial();
    next = nextTrial();
  }
  EXPECT_EQ(protocol.blocks[1].staircase->levelOf(first.caseIndex), 4u);
  EXPECT_EQ(protocol.blocks[1].staircase->levelOf(next.caseIndex), 3u);
}

}  // namespace
}  // namespace ocelli
