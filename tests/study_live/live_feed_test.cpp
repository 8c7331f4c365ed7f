// A whole session with a board: what the experimenter's page is told, and what not.
#include "study/live/live_feed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/study_session/session_harness.h"

namespace ocelli::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class LiveSession {
 public:
  explicit LiveSession(LiveOptions options = {}, bool hasBoard = true)
      : board(hasBoard ? std::make_shared<LiveBoard>() : nullptr),
        feed(sink, protocol, smallSchedule(protocol), board, std::move(options)),
        run(protocol, smallSchedule(protocol), feed) {
    run.whenShown = [this](int64_t nanoseconds) { feed.frameShown(nanoseconds, run.flow); };
  }
  json status() const { return json::parse(board->json()); }

  Protocol protocol = smallProtocol();
  FakeSink sink{};
  std::shared_ptr<LiveBoard> board;
  LiveFeed feed;
  SessionRun run;
};

TEST(LiveBoard, saysThatNothingHasBegun) {
  EXPECT_EQ(json::parse(LiveBoard().json()).at("state"), "not begun");
}

TEST(LiveFeed, followsASessionToItsEnd) {
  LiveSession session;
  session.run.frame();
  EXPECT_EQ(session.status().at("state"), "running");
  EXPECT_EQ(session.status().at("step"), "consent");
  EXPECT_EQ(session.status().at("trials_done"), 0);
  EXPECT_EQ(session.status().at("trials"), 10);
  EXPECT_EQ(session.status().at("left_by"), "protocol");
  session.run.goOn();
  session.feed.finish(session.run.flow);
  const json end = session.status();
  EXPECT_EQ(end.at("state"), "ended");
  EXPECT_EQ(end.at("trials_done"), 10);
  EXPECT_EQ(end.at("left_s"), 0);
  EXPECT_EQ(end.at("left_by"), "pace");
  ASSERT_EQ(end.at("last_trials").size(), LiveFeed::kMaxTrials);
  EXPECT_EQ(end.at("last_trials")[0].at("trial"), 10) << "the newest first";
  EXPECT_EQ(end.at("last_trials")[0].at("outcome"), "right");
  // The timing is that of all trials which have ended.
  int64_t frames = 0;
  const auto ended = session.sink.all<TrialEnds>();
  for (const TrialEnds& trial : ended) {
    frames += trial.record.timing.frames;
  }
  EXPECT_EQ(end.at("timing").at("frames"), frames);
  int verdicts = 0;
  for (const auto& [name, trials] : end.at("timing").at("verdicts").items()) {
    verdicts += trials.get<int>();
  }
  EXPECT_EQ(verdicts, static_cast<int>(ended.size()));
}

/// The status of every quarter of a second, as one text.
std::string allOf(LiveSession& session) {
  std::string text;
  session.run.goOn([&] {
    text += session.board->json() + "\n";
    return false;
  });
  session.feed.finish(session.run.flow);
  return text + session.board->json();
}

TEST(LiveFeed, hidesConditionsUnlessAskedForThem) {
  LiveSession blind;
  const std::string hidden = allOf(blind);
  for (const TrialView view : {TrialView::kReference, TrialView::kOther}) {
    EXPECT_THAT(hidden, Not(HasSubstr("\"" + blind.protocol.nameOf(view) + "\"")));
    EXPECT_THAT(hidden, Not(HasSubstr(" " + blind.protocol.nameOf(view) + ",")));
  }
  LiveSession open({true, {}});
  const std::string shown = allOf(open);
  for (const TrialView view : {TrialView::kReference, TrialView::kOther}) {
    EXPECT_THAT(shown, HasSubstr("\"condition\":\"" + open.protocol.nameOf(view) + "\""));
  }
}

TEST(LiveFeed, tellsNothingThatSomebodyTyped) {
  LiveSession session;
  session.run.frame();
  session.run.flow.note("Anna Example came late");
  session.run.flow.pause("Anna went to the door");
  session.run.flow.resume();
  session.run.flow.report("focus_lost", "Anna");
  const std::string text = allOf(session);
  EXPECT_THAT(text, Not(HasSubstr("Anna")));
  EXPECT_THAT(text, HasSubstr("The window lost the keyboard."));
  for (const AnswerRecord& answer : session.sink.all<AnswerRecord>()) {
    EXPECT_THAT(text, Not(HasSubstr("\"" + answer.answer + "\""))) << answer.field;
  }
}

TEST(LiveFeed, keepsTheNewestWarningsAndCountsAll) {
  LiveSession session;
  for (int i = 0; i < 20; ++i) {
    session.run.flow.report("clock_jump", "+2.000 s");
  }
  session.run.frame();
  EXPECT_EQ(session.status().at("warnings").size(), LiveFeed::kMaxWarnings);
  EXPECT_EQ(session.status().at("warning_count"), 20);
}

TEST(LiveFeed, tellsOfDevicesAndOfPauses) {
  LiveSession session({false, [] { return std::vector<LiveDevice>{{"markers", "3 sent, 1 lost", true}}; }});
  session.run.flow.pause("");
  session.run.frame();
  EXPECT_EQ(session.status().at("state"), "paused");
  EXPECT_EQ(session.status().at("devices")[0],
            json({{"name", "markers"}, {"state", "3 sent, 1 lost"}, {"trouble", true}}));
}

TEST(LiveFeed, passesEverythingOnWithAndWithoutABoard) {
  FakeSink plain;
  const Protocol protocol = smallProtocol();
  SessionRun(protocol, smallSchedule(protocol), plain).goOn();
  for (const bool hasBoard : {true, false}) {
    LiveSession session({}, hasBoard);
    session.run.goOn();
    EXPECT_EQ(session.sink.calls.size(), plain.calls.size());
  }
}

/// A session must not wait for the page: posts are four a second at most, however many frames there are.
TEST(LiveFeed, postsFourTimesASecond) {
  int asked = 0;
  LiveSession session({false, [&] {
                         ++asked;
                         return std::vector<LiveDevice>();
                       }});
  for (int i = 0; i < 240; ++i) {
    session.run.frame();
  }
  EXPECT_GE(asked, 14);
  EXPECT_LE(asked, 17) << "4 seconds";
}

TEST(LiveStatus, isJsonWhateverNamesAreMadeOf) {
  LiveStatus status;
  status.step = "page \xff\"<script>";
  status.devices = {{"a\x01\xc3", "\\", false}};
  EXPECT_NO_THROW(EXPECT_EQ(json::parse(jsonText(status, 1.5)).at("age_s"), 1.5));
}

}  // namespace
}  // namespace ocelli::test
