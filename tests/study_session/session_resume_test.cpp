// Sessions that were cut off and go on.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "oc_core/base/error.h"
#include "tests/study_session/session_harness.h"

namespace ocelli {
namespace {

using test::FakeSink;
using test::SessionRun;

/// How often each plan was completed.
std::map<int, int> completions(std::span<const test::SinkCall> calls) {
  std::map<int, int> counts;
  for (const test::SinkCall& call : calls) {
    const auto* ends = std::get_if<test::TrialEnds>(&call);
    if (ends != nullptr && !ends->record.plan.practice && ends->record.ending == TrialEnding::kCompleted) {
      ++counts[ends->record.plan.index];
    }
  }
  return counts;
}

/// Calls of a session that is cut after each possible record and goes on until its end: `check` is given those before
/// and those after.
template <class Check>
void cutEverywhere(const Protocol& protocol, const Check& check) {
  const SessionSchedule schedule = test::smallSchedule(protocol);
  FakeSink whole;
  SessionRun(protocol, schedule, whole).goOn();
  ASSERT_GT(whole.calls.size(), 50u);
  for (size_t cut = 0; cut + 1 < whole.calls.size(); ++cut) {
    const std::span<const test::SinkCall> before(whole.calls.data(), cut);
    FakeSink after;
    SessionRun run(protocol, schedule, after, test::doneAfter(before, schedule, protocol));
    run.goOn();
    ASSERT_EQ(run.flow.ending(), SessionEnding::kCompleted) << cut;
    check(before, after, schedule);
  }
}

TEST(SessionResume, completesTheScheduleExactlyOnceWhereverItWasCut) {
  const Protocol protocol = test::smallProtocol();
  cutEverywhere(protocol,
                [&](std::span<const test::SinkCall> before, const FakeSink& after, const SessionSchedule& schedule) {
                  std::map<int, int> counts = completions(before);
                  for (const auto& [index, count] : completions(after.calls)) {
                    counts[index] += count;
                  }
                  EXPECT_EQ(counts.size(), schedule.trials.size());
                  for (const auto& [index, count] : counts) {
                    EXPECT_EQ(count, 1) << index;
                  }
                  const SessionDone done = test::doneAfter(before, schedule, protocol);
                  EXPECT_EQ(after.all<ConsentRecord>().empty(), done.consented);
                  size_t asked = 0;
                  for (const AnswerRecord& answer : after.all<AnswerRecord>()) {
                    EXPECT_EQ(std::count(done.forms.begin(), done.forms.end(), answer.form), 0);
                    ++asked;
                  }
                  EXPECT_EQ(asked, 3 - (done.forms.empty() ? 0u : done.forms.size() == 1 ? 2u : 3u));
                  bool practiced = false;
                  for (const test::TrialBegins& begins : after.all<test::TrialBegins>()) {
                    practiced = practiced || begins.plan.practice;
                    if (!begins.plan.practice) {
                      EXPECT_EQ(begins.attempt, done.attempts[static_cast<size_t>(begins.plan.index)] + 1);
                    }
                  }
                  EXPECT_EQ(practiced, done.blocksPracticed.empty());
                });
}

TEST(SessionResume, formsBeforeAndAfterAreAskedWhereverItWasCut) {
  Protocol protocol = test::smallProtocol();
  const auto form = [](const std::string& name) {
    return ProtocolForm{name, "Form", "", {{"a", "A?", {"x", "y"}}, {"b", "B?", {"x", "y"}}}};
  };
  protocol.before = {form("own before")};
  protocol.after = {form("own after")};
  for (ProtocolBlock& block : protocol.blocks) {
    block.after = {form("own after " + block.name)};
  }
  const size_t forms = 2 + protocol.blocks.size();
  cutEverywhere(
      protocol, [&](std::span<const test::SinkCall> before, const FakeSink& after, const SessionSchedule& schedule) {
        const SessionDone done = test::doneAfter(before, schedule, protocol);
        std::map<std::string, int> asked;
        for (const AnswerRecord& answer : after.all<AnswerRecord>()) {
          ++asked[answer.form];
        }
        size_t own = 0;
        for (const auto& [name, answers] : asked) {
          EXPECT_EQ(answers, name == "demographics" ? 2 : name == "survey" ? 1 : 2) << name;
          EXPECT_EQ(std::count(done.forms.begin(), done.forms.end(), name), 0) << name << " was answered before";
          own += name.starts_with("own") ? 1 : 0;
        }
        const auto isOwn = [](const std::string& name) { return name.starts_with("own"); };
        const auto answered = static_cast<size_t>(std::count_if(done.forms.begin(), done.forms.end(), isOwn));
        EXPECT_EQ(own + answered, forms) << "each is asked in the end";
      });
}

TEST(SessionResume, attemptsAtPracticeAreCountedOnAcrossRuns) {
  const Protocol protocol = test::smallProtocol();
  cutEverywhere(protocol, [&](std::span<const test::SinkCall> before, const FakeSink& after, const SessionSchedule&) {
    std::map<int, std::vector<int>> attempts;  // by case
    const auto note = [&](const test::SinkCall& call) {
      const auto* begins = std::get_if<test::TrialBegins>(&call);
      if (begins != nullptr && begins->plan.practice) {
        attempts[begins->plan.caseIndex].push_back(begins->attempt);
      }
    };
    std::for_each(before.begin(), before.end(), note);
    std::for_each(after.calls.begin(), after.calls.end(), note);
    for (const auto& [index, counted] : attempts) {
      for (size_t i = 0; i < counted.size(); ++i) {
        EXPECT_EQ(counted[i], static_cast<int>(i) + 1);
      }
    }
  });
}

TEST(SessionResume, blocksBeginAnewWhereTheProtocolSaysSo) {
  Protocol protocol = test::smallProtocol();
  protocol.resume = ResumePolicy::kRestartBlock;
  cutEverywhere(protocol,
                [&](std::span<const test::SinkCall> before, const FakeSink& after, const SessionSchedule& schedule) {
                  const std::map<int, int> first = completions(before);
                  const std::map<int, int> second = completions(after.calls);
                  for (size_t block = 0; block < protocol.blocks.size(); ++block) {
                    size_t trials = 0;
                    size_t doneBefore = 0;
                    size_t doneAfter = 0;
                    for (const TrialPlan& plan : schedule.trials) {
                      if (plan.block == static_cast<int>(block)) {
                        ++trials;
                        doneBefore += first.contains(plan.index) ? 1 : 0;
                        doneAfter += second.contains(plan.index) ? 1 : 0;
                      }
                    }
                    EXPECT_EQ(doneAfter, doneBefore == trials ? 0 : trials);
                  }
                });
}

TEST(SessionResume, isRefusedWhereTheProtocolSaysSo) {
  Protocol protocol = test::smallProtocol();
  protocol.resume = ResumePolicy::kStop;
  const SessionSchedule schedule = test::smallSchedule(protocol);
  FakeSink sink;
  SessionDone done;
  done.consented = true;
  SessionRun fine(protocol, schedule, sink, done);  // no trial yet
  done.attempts.resize(schedule.trials.size());
  done.attempts[0] = 1;
  EXPECT_THROW(SessionRun(protocol, schedule, sink, done), InputError);
}

TEST(SessionResume, aSessionThatWasDoneEndsAtOnce) {
  const Protocol protocol = test::smallProtocol();
  const SessionSchedule schedule = test::smallSchedule(protocol);
  FakeSink whole;
  SessionRun(protocol, schedule, whole).goOn();
  FakeSink sink;
  SessionRun run(protocol, schedule, sink, test::doneAfter(whole.calls, schedule, protocol));
  EXPECT_EQ(run.flow.ending(), SessionEnding::kCompleted);
  run.goOn();
  EXPECT_TRUE(sink.all<test::TrialBegins>().empty());
}

}  // namespace
}  // namespace ocelli
