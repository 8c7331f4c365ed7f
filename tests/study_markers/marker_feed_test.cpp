// A whole session with markers: each has its frame, in order, and the session goes on whatever becomes of them.
#include "study/markers/marker_feed.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/study_session/session_harness.h"

namespace ocelli::test {
namespace {

/// Keeps what it is sent; or loses all of it.
class KeptMarkers : public MarkerOutput {
 public:
  KeptMarkers(std::vector<Marker>& kept, bool loses) : kept_(kept), loses_(loses) {}
  void send(const Marker& marker) override {
    if (loses_) {
      ++counts_.lost;
    } else {
      ++counts_.sent;
      kept_.push_back(marker);
    }
  }
  MarkerCounts counts() const override { return counts_; }

 private:
  std::vector<Marker>& kept_;
  bool loses_;
  MarkerCounts counts_{};
};

struct MarkedSession {
  explicit MarkedSession(bool loses = false) {
    std::vector<std::unique_ptr<MarkerOutput>> outputs;
    outputs.push_back(std::make_unique<KeptMarkers>(markers, loses));
    MarkerFeed feed(sink, protocol, std::move(outputs));
    SessionRun run(protocol, smallSchedule(protocol), feed);
    run.whenShown = [&](int64_t nanoseconds) { feed.frameShown(nanoseconds); };
    run.goOn();
    feed.finish(run.now);
    counts = feed.counts().front();
  }

  Protocol protocol = smallProtocol();
  FakeSink sink{};
  std::vector<Marker> markers{};
  MarkerCounts counts{};
};

TEST(MarkerFeed, everyTrialBeginsAnswersAndEnds) {
  const MarkedSession session;
  ASSERT_GT(session.markers.size(), 4u);
  EXPECT_EQ(session.markers.front().code.code, kSessionStarts.code);
  EXPECT_EQ(session.markers.back().code.code, kSessionEnds.code);
  EXPECT_EQ(session.markers.back().answer, "completed");
  std::map<int, std::vector<int>> codes;
  for (size_t i = 0; i < session.markers.size(); ++i) {
    const Marker& marker = session.markers[i];
    EXPECT_EQ(marker.sequence, static_cast<int64_t>(i));
    EXPECT_GE(marker.nanoseconds, i == 0 ? 0 : session.markers[i - 1].nanoseconds);
    codes[marker.trial].push_back(marker.code.code);
  }
  codes.erase(-1);
  const auto ended = session.sink.all<TrialEnds>();
  EXPECT_EQ(codes.size(), ended.size());
  for (const TrialEnds& each : ended) {
    const TrialRecord& record = each.record;
    const bool isReference = record.plan.view == TrialView::kReference;
    const int start = (record.plan.practice ? 12 : 10) + (isReference ? 0 : 1);
    const int answer = record.outcome.correct ? 20 : record.outcome.censored ? 22 : 21;
    EXPECT_EQ(codes[each.number], (std::vector<int>{start, answer, 30})) << each.number;
  }
}

TEST(MarkerFeed, aStartHasTheTimeOfTheFirstFrameAndAnEndThatOfTheNext) {
  const MarkedSession session;
  for (const TrialEnds& each : session.sink.all<TrialEnds>()) {
    for (const Marker& marker : session.markers) {
      if (marker.trial == each.number && marker.code.code < 20) {
        EXPECT_EQ(marker.nanoseconds, each.record.startedNanoseconds) << "as the database has it";
        EXPECT_EQ(marker.condition, session.protocol.nameOf(each.record.plan.view));
      } else if (marker.trial == each.number) {
        EXPECT_GE(marker.nanoseconds, each.record.endedNanoseconds);
        // The frame that follows: the harness shows 60 a second.
        EXPECT_LE(marker.nanoseconds, each.record.endedNanoseconds + 2 * 17'000'000);
      }
    }
  }
}

TEST(MarkerFeed, aSessionIsTheSameWhateverBecomesOfItsMarkers) {
  const MarkedSession with;
  const MarkedSession lost(true);
  EXPECT_TRUE(lost.markers.empty());
  EXPECT_EQ(lost.counts.lost, with.counts.sent);
  EXPECT_EQ(lost.sink.calls.size(), with.sink.calls.size());
  FakeSink plain;
  const Protocol protocol = smallProtocol();
  SessionRun(protocol, smallSchedule(protocol), plain).goOn();
  EXPECT_EQ(with.sink.calls.size(), plain.calls.size()) << "all records are passed on";
}

}  // namespace
}  // namespace ocelli::test
