#include "study/session/session_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/sha256.h"
#include "tests/study_session/session_harness.h"

namespace ocelli {
namespace {

using test::FakeSink;
using test::SessionRun;

struct Small {
  Protocol protocol = test::smallProtocol();
  SessionSchedule schedule = test::smallSchedule(protocol);
  FakeSink sink{};
};

std::vector<int> completedOf(const FakeSink& sink) {
  std::vector<int> completed;
  for (const test::TrialEnds& end : sink.all<test::TrialEnds>()) {
    if (!end.record.plan.practice && end.record.ending == TrialEnding::kCompleted) {
      completed.push_back(end.record.plan.index);
    }
  }
  return completed;
}

std::vector<int> inOrder(size_t count) {
  std::vector<int> numbers;
  for (size_t i = 0; i < count; ++i) {
    numbers.push_back(static_cast<int>(i));
  }
  return numbers;
}

TEST(SessionFlow, keysAloneLeadThroughAWholeSession) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.goOn();
  EXPECT_EQ(run.flow.ending(), SessionEnding::kCompleted);
  EXPECT_EQ(completedOf(small.sink), inOrder(small.schedule.trials.size()));
  ASSERT_EQ(small.sink.all<ConsentRecord>().size(), 1u);
  const ConsentRecord consent = small.sink.all<ConsentRecord>()[0];
  EXPECT_TRUE(consent.agreed);
  EXPECT_EQ(consent.text, "You may stop at any time.\n\nDo you take part?");
  EXPECT_EQ(consent.sha256, sha256(consent.text));
  const auto answers = small.sink.all<AnswerRecord>();
  ASSERT_EQ(answers.size(), 3u);
  EXPECT_EQ(answers[0].form + answers[0].field + answers[0].answer, "demographicsage_band18-29");
  EXPECT_EQ(answers[1].field, "vision");
  EXPECT_EQ(answers[2].form, "survey");
  const auto ends = small.sink.all<test::TrialEnds>();
  for (const test::TrialEnds& end : ends) {
    EXPECT_TRUE(end.record.outcome.correct);
    EXPECT_EQ(end.record.attempt, 1);
    EXPECT_EQ(end.record.timing.verdict, TimingVerdict::kGood);
  }
  // Practice: two right ones in a row are enough, and come first.
  ASSERT_GE(ends.size(), 3u);
  EXPECT_TRUE(ends[0].record.plan.practice && ends[1].record.plan.practice);
  EXPECT_FALSE(ends[2].record.plan.practice);
  EXPECT_TRUE(small.sink.hasEvent("practice_passed"));
}

TEST(SessionFlow, recordsOfATrialComeInOrder) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.goOn();
  std::optional<int> running;
  int next = 0;
  for (const test::SinkCall& call : small.sink.calls) {
    if (const auto* begins = std::get_if<test::TrialBegins>(&call)) {
      EXPECT_FALSE(running.has_value());
      EXPECT_EQ(begins->number, next++);
      running = begins->number;
    } else if (const auto* frames = std::get_if<test::TrialFrames>(&call)) {
      EXPECT_EQ(running, frames->number);
    } else if (const auto* inputs = std::get_if<test::TrialInputs>(&call)) {
      EXPECT_EQ(running, inputs->number);
    } else if (const auto* ends = std::get_if<test::TrialEnds>(&call)) {
      EXPECT_EQ(running, ends->number);
      running.reset();
      const std::vector<FrameRecord> shown = small.sink.framesOf(ends->number);
      EXPECT_EQ(static_cast<int64_t>(shown.size()), ends->record.timing.frames);
      for (size_t i = 0; i < shown.size(); ++i) {
        EXPECT_EQ(shown[i].frame, static_cast<int64_t>(i));
      }
      EXPECT_EQ(shown.front().tick, 0);
      EXPECT_EQ(ends->record.startedNanoseconds, shown.front().shownNanoseconds);
    }
  }
  EXPECT_TRUE(std::holds_alternative<test::SessionEnds>(small.sink.calls.back()));
}

TEST(SessionFlow, ticksFollowFromTimes) {
  Small small;
  small.protocol.consent.reset();
  small.protocol.demographics.reset();
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.goOn([&] { return run.page() != nullptr && run.page()->title == "Practice"; });
  run.press(Key::kEnter);
  run.frame();
  ASSERT_TRUE(run.inTrial());
  const int64_t start = run.now + 1'000'000;  // it was shown after 1 ms
  const auto inputAt = [&](int64_t nanoseconds) {
    run.flow.handle({KeyEvent{Key::kX, true, {}}, start + nanoseconds});
  };
  const auto updateAt = [&](int64_t nanoseconds) { run.flow.update(start + nanoseconds); };
  inputAt(-500'000);     // before the first frame, told after it: tick 0 is over
  inputAt(4'166'666);    // just before the end of tick 0: likewise
  inputAt(4'166'667);    // the first nanosecond of tick 1
  inputAt(50'000'000);   // exactly tick 12
  updateAt(60'000'000);  // tick 14
  run.flow.frameShown(start + 61'000'000);
  inputAt(58'000'000);   // late, and tick 14 was shown
  updateAt(60'100'000);  // still tick 14
  updateAt(1'000'000'000);
  inputAt(1'000'000'000);  // tick 240, not shown yet
  updateAt(1'000'000'001);
  run.flow.abort("enough");
  const std::vector<InputRecord> inputs = small.sink.inputsOf(0);
  std::vector<int64_t> ticks;
  for (const InputRecord& input : inputs) {
    if (std::get<KeyEvent>(input.event).key == Key::kX) {
      ticks.push_back(input.tick);
    }
  }
  EXPECT_EQ(ticks, (std::vector<int64_t>{1, 1, 1, 12, 15, 240}));
  const std::vector<FrameRecord> frames = small.sink.framesOf(0);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[1].tick, 14);
}

TEST(SessionFlow, pausingATrialBringsItAgain) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  int seen = 0;
  run.goOn([&] { return run.inTrial() && !run.flow.trialPlan()->practice && ++seen == 2; });
  const TrialPlan plan = *run.flow.trialPlan();
  run.frame();
  run.flow.pause("a question");
  EXPECT_FALSE(run.inTrial());
  EXPECT_TRUE(run.flow.status().paused);
  run.tap(Key::kEnter);  // not the subject's to end
  ASSERT_TRUE(std::holds_alternative<PauseScreen>(run.flow.screen()));
  EXPECT_EQ(std::get<PauseScreen>(run.flow.screen()).reason, "a question");
  run.flow.resume();
  run.goOn([&] { return run.inTrial(); });
  EXPECT_EQ(*run.flow.trialPlan(), plan);
  run.goOn();
  const auto ends = small.sink.all<test::TrialEnds>();
  std::vector<TrialEnding> endings;
  std::vector<int> attempts;
  for (const test::TrialEnds& end : ends) {
    if (end.record.plan == plan) {
      endings.push_back(end.record.ending);
      attempts.push_back(end.record.attempt);
    }
  }
  EXPECT_EQ(endings, (std::vector{TrialEnding::kAborted, TrialEnding::kCompleted}));
  EXPECT_EQ(attempts, (std::vector{1, 2}));
  EXPECT_EQ(completedOf(small.sink), inOrder(small.schedule.trials.size()));
  EXPECT_TRUE(small.sink.hasEvent("pause") && small.sink.hasEvent("resume"));
}

TEST(SessionFlow, redoTakesTheTrialThatRunsOrTheLast) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.flow.redo();  // nothing yet
  const auto isInTrial = [&](int index) {
    return [&run, index] { return run.inTrial() && run.flow.trialPlan()->index == index; };
  };
  run.goOn(isInTrial(1));
  run.flow.redo();
  EXPECT_FALSE(run.inTrial());
  run.goOn(isInTrial(1));
  run.goOn([&] { return !run.inTrial(); });  // done: its feedback is shown
  ASSERT_NE(run.page(), nullptr);
  EXPECT_EQ(run.page()->good, true);
  run.flow.redo();
  run.goOn(isInTrial(1));
  run.goOn();
  std::vector<std::string> endings;
  for (const test::TrialEnds& end : small.sink.all<test::TrialEnds>()) {
    if (end.record.plan.index == 1) {
      endings.push_back(nameOf(end.record.ending) + std::to_string(end.record.attempt));
    }
  }
  EXPECT_EQ(endings, (std::vector<std::string>{"redone1", "completed2", "completed3"}));
  EXPECT_EQ(run.flow.ending(), SessionEnding::kCompleted);
  // Feedback of the first go was left out: one for each trial that counts, and two for practice.
  std::vector<int> expected = inOrder(small.schedule.trials.size());
  expected.insert(expected.begin() + 1, 1);
  EXPECT_EQ(completedOf(small.sink), expected);
}

TEST(SessionFlow, practiceThatFailsCallsTheExperimenter) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.answer = Key::k9;
  run.goOn([&] { return small.sink.hasEvent("practice_failed"); });
  EXPECT_TRUE(run.flow.status().wantsExperimenter);
  EXPECT_EQ(small.sink.all<test::TrialEnds>().size(), 3u);  // "most trials"
  run.tap(Key::kEnter);  // not the subject's to pass, neither by keys nor by the mouse
  run.flow.act({FormAction::Kind::kGoOn}, run.now);
  EXPECT_TRUE(run.flow.status().wantsExperimenter);
  EXPECT_FALSE(small.sink.hasEvent("practice_continued"));
  run.flow.resume();
  EXPECT_FALSE(run.flow.status().wantsExperimenter);
  run.goOn([&] { return run.inTrial(); });
  EXPECT_FALSE(run.flow.trialPlan()->practice);
  EXPECT_TRUE(small.sink.hasEvent("practice_continued"));
}

TEST(SessionFlow, theExperimentersKeyGoesOnAfterPracticeThatFailed) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.tap(Key::kF12);  // nothing to go on with
  run.answer = Key::k9;
  run.goOn([&] { return small.sink.hasEvent("practice_failed"); });
  run.flow.pause("a question");
  run.tap(Key::kF12);
  EXPECT_FALSE(small.sink.hasEvent("practice_continued"));
  run.flow.resume();
  EXPECT_TRUE(run.flow.status().wantsExperimenter);  // it ended the pause alone
  run.tap(Key::kF12);
  EXPECT_TRUE(small.sink.hasEvent("practice_continued"));
}

TEST(SessionFlow, notesAreStoredAfterTheEnd) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.tap(Key::kF10);
  run.tap(Key::kEnter);
  ASSERT_EQ(run.flow.ending(), SessionEnding::kUnwell);
  EXPECT_TRUE(run.flow.note("a headache"));
  EXPECT_EQ(small.sink.all<EventRecord>().back().detail, "a headache");

  Small declined;
  SessionRun other(declined.protocol, declined.schedule, declined.sink);
  other.tap(Key::kEscape);
  EXPECT_FALSE(other.flow.note("no time"));
  EXPECT_FALSE(declined.sink.hasEvent("note"));
}

TEST(SessionFlow, redoDuringABreakDoesNotBeginItAgain) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  const auto begun = [&] {
    const auto events = small.sink.all<EventRecord>();
    return std::count_if(events.begin(), events.end(),
                         [](const EventRecord& event) { return event.what == "break" && event.detail == "begins"; });
  };
  run.goOn([&] { return small.sink.hasEvent("break"); });
  const int64_t began = run.now;
  const TrialPlan last = small.sink.all<test::TrialEnds>().back().record.plan;
  EXPECT_TRUE(run.flow.redo());
  run.goOn([&] { return run.inTrial(); });
  EXPECT_EQ(*run.flow.trialPlan(), last);
  run.goOn([&] { return run.page() != nullptr && run.page()->title == "A break"; });
  EXPECT_EQ(begun(), 1);
  EXPECT_NEAR(run.page()->waitSeconds, 2 - static_cast<double>(run.now - began) * 1e-9, 0.05);  // three frames
}

TEST(SessionFlow, redoSaysWhereNothingIsDoneAgain) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  EXPECT_FALSE(run.flow.redo());  // no trial yet
  run.goOn([&] { return run.inTrial(); });
  EXPECT_TRUE(run.flow.redo());
  run.goOn();
  EXPECT_FALSE(run.flow.redo());
}

TEST(SessionFlow, aFailureSaysWhy) {
  Small small;
  small.sink.failsAfter = 3;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.goOn();
  EXPECT_EQ(run.flow.ending(), SessionEnding::kFailed);
  EXPECT_EQ(run.flow.status().failure, "the disk is full");
}

TEST(SessionFlow, oneRightPracticeTrialBetweenWrongOnesIsNotInARow) {
  Small small;
  small.protocol.blocks[0].practice->maxTrials = 8;
  SessionRun run(small.protocol, small.schedule, small.sink);
  const auto trials = [&](size_t count) {
    return [&small, count] { return small.sink.all<test::TrialEnds>().size() == count; };
  };
  run.goOn(trials(1));
  run.answer = Key::k9;
  run.goOn(trials(2));
  run.answer.reset();
  run.goOn(trials(3));
  EXPECT_FALSE(small.sink.hasEvent("practice_passed"));
  run.goOn(trials(4));
  run.tap(Key::kEnter);
  EXPECT_TRUE(small.sink.hasEvent("practice_passed"));
}

TEST(SessionFlow, aPracticeTrialThatIsRedoneCountsOnce) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  const auto isDone = [&](size_t count) {
    return [&small, count] { return small.sink.all<test::TrialEnds>().size() == count; };
  };
  run.goOn(isDone(1));
  run.flow.redo();
  run.goOn(isDone(2));
  const auto ends = small.sink.all<test::TrialEnds>();
  EXPECT_EQ(ends[1].record.plan, ends[0].record.plan);
  EXPECT_EQ(ends[1].record.attempt, 2);
  run.tap(Key::kEnter);
  EXPECT_FALSE(small.sink.hasEvent("practice_passed"));  // one right one, however often
  run.goOn(isDone(3));
  run.tap(Key::kEnter);
  EXPECT_TRUE(small.sink.hasEvent("practice_passed"));
}

/// Of each practice trial that ended, in which view it was; "!" after a wrong one.
std::string practiced(const FakeSink& sink) {
  std::string views;
  for (const test::TrialEnds& end : sink.all<test::TrialEnds>()) {
    if (end.record.plan.practice) {
      views += end.record.plan.view == TrialView::kReference ? "r" : "o";
      views += end.record.outcome.correct ? "" : "!";
    }
  }
  return views;
}

TEST(SessionFlow, eachViewIsPractisedToItsCriterionWhereTheProtocolAsksForIt) {
  Small small;
  small.protocol.blocks[0].practice->maxTrials = 4;
  small.protocol.blocks[0].practice->eachView = true;
  SessionRun run(small.protocol, small.schedule, small.sink);
  const auto isDone = [&](size_t count) {
    return [&small, count] { return small.sink.all<test::TrialEnds>().size() == count; };
  };
  run.goOn(isDone(1));
  run.answer = Key::k9;
  run.goOn(isDone(2));  // wrong: it begins again
  run.answer.reset();
  run.goOn(isDone(4));
  EXPECT_FALSE(small.sink.hasEvent("practice_view_passed"));
  run.tap(Key::kEnter);
  EXPECT_TRUE(small.sink.hasEvent("practice_view_passed"));
  EXPECT_FALSE(small.sink.hasEvent("practice_passed"));
  run.goOn([&] { return run.inTrial() && !run.flow.trialPlan()->practice; });
  EXPECT_TRUE(small.sink.hasEvent("practice_passed"));
  EXPECT_EQ(practiced(small.sink), small.schedule.firstView == TrialView::kReference ? "rr!rroo" : "oo!oorr");
  std::set<uint64_t> seeds;
  for (const test::TrialEnds& end : small.sink.all<test::TrialEnds>()) {
    EXPECT_TRUE(seeds.insert(end.record.plan.seed).second);
  }
}

TEST(SessionFlow, aViewThatFailsInPracticeCallsTheExperimenterAndTheOtherIsPractisedAllTheSame) {
  Small small;
  small.protocol.blocks[0].practice->eachView = true;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.answer = Key::k9;
  run.goOn([&] { return small.sink.hasEvent("practice_failed"); });
  EXPECT_EQ(small.sink.all<test::TrialEnds>().size(), 3u);  // "most trials", of one view
  run.flow.resume();
  EXPECT_TRUE(small.sink.hasEvent("practice_view_continued"));
  // Who resumes the session now practises both again.
  EXPECT_TRUE(test::doneAfter(small.sink.calls, small.schedule, small.protocol).blocksPracticed.empty());
  run.answer.reset();
  run.goOn([&] { return run.inTrial() && !run.flow.trialPlan()->practice; });
  EXPECT_EQ(practiced(small.sink), small.schedule.firstView == TrialView::kReference ? "r!r!r!oo" : "o!o!o!rr");
  EXPECT_TRUE(small.sink.hasEvent("practice_passed"));
  EXPECT_FALSE(small.sink.hasEvent("practice_continued"));
  EXPECT_EQ(test::doneAfter(small.sink.calls, small.schedule, small.protocol).blocksPracticed, (std::vector{0}));
}

TEST(SessionFlow, logsHoldWhatTasksCanUse) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.goOn([&] { return run.inTrial(); });
  run.input(TextEvent{U'x'});
  run.input(CloseEvent{});
  run.input(PointerMoveEvent{std::nan(""), 3});
  run.input(PointerMoveEvent{4, 3});
  run.frame();
  run.frame();
  run.flow.abort("enough");
  size_t moves = 0;
  for (const InputRecord& input : small.sink.inputsOf(0)) {
    const auto* move = std::get_if<PointerMoveEvent>(&input.event);
    EXPECT_TRUE(move != nullptr || std::holds_alternative<KeyEvent>(input.event));
    moves += move != nullptr ? 1 : 0;
  }
  EXPECT_EQ(moves, 1u);
}

/// It fits onto large screens alone.
class LargeTask : public TaskBlock {
 public:
  int caseCount() const override { return 1; }
  CaseInfo caseInfo(int) const override { return CaseInfo(); }
  std::string answerOf(const TrialPlan&) const override { return "none"; }
  std::unique_ptr<TrialRun> start(const TrialPlan&, const TrialScreen&) const override {
    throw InputError("too small", "screen", "take a larger one");
  }
};

TEST(SessionFlow, whatDoesNotFitOntoTheScreenIsToldBeforeTheSession) {
  Small small;
  small.protocol.blocks[1].task = std::make_shared<LargeTask>();
  const SessionSchedule schedule = test::smallSchedule(small.protocol);
  EXPECT_THROW(SessionRun(small.protocol, schedule, small.sink), InputError);
  EXPECT_TRUE(small.sink.calls.empty());
}

TEST(SessionFlow, decliningEndsTheSession) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  ASSERT_TRUE(std::holds_alternative<ConsentScreen>(run.flow.screen()));
  run.tap(Key::kEscape);
  EXPECT_EQ(run.flow.ending(), SessionEnding::kDeclined);
  EXPECT_FALSE(run.flow.isOver());  // a last page
  run.goOn();
  ASSERT_EQ(small.sink.calls.size(), 2u);
  EXPECT_FALSE(small.sink.all<ConsentRecord>()[0].agreed);
  EXPECT_EQ(small.sink.all<test::SessionEnds>()[0].ending, SessionEnding::kDeclined);
}

TEST(SessionFlow, breaksLastAtLeastAsLongAsTheyShould) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.goOn([&] { return small.sink.hasEvent("break"); });
  ASSERT_NE(run.page(), nullptr);
  EXPECT_EQ(run.page()->progress->trialsDone, 2);
  EXPECT_GT(run.page()->waitSeconds, 1.9);
  run.tap(Key::kEnter);
  EXPECT_GT(run.page()->waitSeconds, 1.8);
  for (int i = 0; i < 120; ++i) {
    run.frame();
  }
  EXPECT_EQ(run.page()->waitSeconds, 0);
  run.tap(Key::kEnter);
  EXPECT_EQ(run.page()->title, "Trial 3 of 10");
}

TEST(SessionFlow, aKeyThatIsHeldGoesOnOnce) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  for (int i = 0; i < 30; ++i) {
    run.press(Key::kEnter);  // repeats
    run.frame();
  }
  EXPECT_TRUE(std::holds_alternative<FormScreen>(run.flow.screen()));
}

TEST(SessionFlow, fullDiskStopsTheSession) {
  Small whole;
  SessionRun(whole.protocol, whole.schedule, whole.sink).goOn();
  for (size_t calls = 0; calls < whole.sink.calls.size(); calls += 3) {
    Small small;
    small.sink.failsAfter = calls;
    SessionRun run(small.protocol, small.schedule, small.sink);
    run.goOn([&] { return run.flow.ending() == SessionEnding::kFailed; });
    ASSERT_NE(run.page(), nullptr);
    EXPECT_EQ(run.page()->title, "The session has stopped");
    EXPECT_EQ(run.page()->paragraphs.back(), "the disk is full");
    EXPECT_FALSE(run.inTrial());
    run.goOn();
    EXPECT_EQ(run.flow.ending(), SessionEnding::kFailed);
    // At most what one update leaves comes after the failure.
    EXPECT_LE(small.sink.calls.size(), calls + 8);
  }
}

TEST(SessionFlow, abortEndsWithAPage) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.goOn([&] { return run.inTrial(); });
  run.flow.note("the subject has a cold");
  run.flow.abort("fire alarm");
  EXPECT_EQ(run.flow.ending(), SessionEnding::kAborted);
  EXPECT_FALSE(run.flow.isOver());
  run.flow.abort("again");
  EXPECT_TRUE(run.flow.isOver());
  EXPECT_TRUE(small.sink.hasEvent("note"));
  EXPECT_EQ(small.sink.all<test::TrialEnds>().back().record.ending, TrialEnding::kAborted);
  EXPECT_EQ(small.sink.all<test::SessionEnds>().size(), 1u);
}

TEST(SessionFlow, widgetsDoWhatKeysDo) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  const auto act = [&](FormAction::Kind kind, int field = 0, int option = 0) {
    run.flow.act({kind, field, {option}}, run.now);
    run.frame();
  };
  act(FormAction::Kind::kGoOn);
  act(FormAction::Kind::kGoOn);
  ASSERT_TRUE(std::holds_alternative<FormScreen>(run.flow.screen()));
  EXPECT_TRUE(std::get<FormScreen>(run.flow.screen()).missing);
  act(FormAction::Kind::kClick, 0, 2);
  act(FormAction::Kind::kClick, 1, 1);
  act(FormAction::Kind::kClick, 1, 7);   // no such option
  act(FormAction::Kind::kClick, -1, 0);  // no such field
  act(FormAction::Kind::kGoOn);
  const auto answers = small.sink.all<AnswerRecord>();
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_EQ(answers[0].answer, "50 or more");
  EXPECT_EQ(answers[1].answer, "with glasses");
}

TEST(SessionFlow, unwellAtAnyMoment) {
  Small whole;
  SessionRun count(whole.protocol, whole.schedule, whole.sink);
  int taps = 0;
  count.goOn([&] { return ++taps < 0; });
  for (int at = 1; at < taps - 1; ++at) {
    for (const bool ends : {true, false}) {
      Small small;
      SessionRun run(small.protocol, small.schedule, small.sink);
      int tapsNow = 0;
      run.goOn([&] { return ++tapsNow == at; });
      const bool wasOver = run.flow.status().step.rfind("ended", 0) == 0;
      const std::string step = run.flow.status().step;
      run.tap(Key::kF10);
      if (wasOver) {
        continue;
      }
      ASSERT_NE(run.page(), nullptr);
      EXPECT_EQ(run.page()->title, "Do you feel unwell?") << step;
      EXPECT_FALSE(run.inTrial());
      run.tap(ends ? Key::kEnter : Key::kEscape);
      run.goOn();
      EXPECT_EQ(run.flow.ending(), ends ? SessionEnding::kUnwell : SessionEnding::kCompleted) << step;
      EXPECT_EQ(small.sink.all<test::SessionEnds>().size(), 1u);
      EXPECT_TRUE(small.sink.hasEvent("unwell"));
      if (!ends) {
        EXPECT_EQ(completedOf(small.sink), inOrder(small.schedule.trials.size())) << step;
      }
    }
  }
}

TEST(SessionFlow, lateFramesMarkTheTrial) {
  Small small;
  SessionRun run(small.protocol, small.schedule, small.sink);
  run.goOn([&] { return run.inTrial(); });
  for (int i = 0; i < 20; ++i) {
    run.frame(i == 5 ? 2 * test::kFrameNanoseconds : test::kFrameNanoseconds);
  }
  run.goOn([&] { return !run.inTrial(); });
  const TrialTiming timing = small.sink.all<test::TrialEnds>()[0].record.timing;
  EXPECT_EQ(timing.dropped, 1);
  EXPECT_EQ(timing.verdict, TimingVerdict::kDroppedFrames);
  EXPECT_EQ(timing.longestNanoseconds, 2 * test::kFrameNanoseconds);
  EXPECT_EQ(timing.medianNanoseconds, test::kFrameNanoseconds);
  EXPECT_TRUE(small.sink.hasEvent("late_frames"));
  EXPECT_EQ(run.flow.status().lastTiming.dropped, 1);
}

}  // namespace
}  // namespace ocelli
