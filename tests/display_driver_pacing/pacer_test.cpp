#include "display_driver/pacing/pacer.h"

#include <gtest/gtest.h>

#include <set>

#include "oc_core/base/random.h"
#include "tests/display_driver_pacing/virtual_display.h"

namespace ocelli {
namespace {

using test::VirtualClock;
using test::VirtualDisplay;
using test::VirtualDisplayOptions;
using test::VirtualSource;

constexpr double kRefresh = 1000.0 / 24;  // milliseconds
constexpr double kSeconds = 10;

struct PacedRun {
  explicit PacedRun(std::function<double(int)> making, VirtualDisplayOptions options = {})
      : display(clock, std::move(options)), source(clock, std::move(making)) {}

  void go(double seconds = kSeconds, const std::function<void(const RefreshRecord&)>& also = {}) {
    Pacer pacer(display, source, clock, {.seconds = seconds});
    summary = pacer.run({}, [&](const RefreshRecord& record) {
      records.push_back(record);
      if (also) {
        also(record);
      }
    });
  }
  uint64_t count(RefreshOutcome outcome) const { return summary.count(outcome); }

  VirtualClock clock;
  VirtualDisplay display;
  VirtualSource source;
  std::vector<RefreshRecord> records;
  TimeLineSummary summary;
};

std::function<double(int)> always(double milliseconds) {
  return [milliseconds](int) { return milliseconds; };
}

TEST(PacerTest, whatCanBeDoneInTimeIsDoneAtEveryRefresh) {
  PacedRun run(always(12));
  run.go();
  // What is foreseen of the first frames is a guess: they may come at the second refresh.
  EXPECT_NEAR(static_cast<double>(run.summary.refreshes), 24 * kSeconds, 3);
  EXPECT_LE(run.summary.misses, 1u);
  EXPECT_EQ(run.display.shown.size(), run.count(RefreshOutcome::kShown));
}

TEST(PacerTest, volumesAreAsFreshAsTheStagesAllow) {
  PacedRun run(always(12));
  run.go();
  // 12 ms of making, 5 on the link, and a guard of 1 and what the clock is unsure about.
  EXPECT_GE(run.summary.latency.median, 17);
  EXPECT_LE(run.summary.latency.median, 20);
  EXPECT_NEAR(run.summary.making.median, 12, 1e-3);
  EXPECT_NEAR(run.summary.sending.median, 5, 1e-3);
}

TEST(PacerTest, theSourceIsToldWhenItsVolumeWillBeSeen) {
  PacedRun run(always(12));
  run.go();
  size_t frames = 0;
  for (const RefreshRecord& record : run.records) {
    if (record.frame > 10) {
      const double error =
          std::chrono::duration<double, std::milli>(record.shown - run.source.seen[record.frame - 1]).count();
      EXPECT_NEAR(error, 0, 0.01) << record.frame;
      ++frames;
    }
  }
  EXPECT_GT(frames, 200u);
}

TEST(PacerTest, aMotorThatIsNotAsFastAsItShouldBeIsFollowed) {
  for (const double factor : {0.97, 1.02}) {
    PacedRun run(always(12), {.rotationsPerMinute = 720 * factor});
    run.go();
    EXPECT_NEAR(static_cast<double>(run.summary.refreshes), 24 * kSeconds * factor, 3);
    EXPECT_LE(run.summary.misses, 1u) << factor;
  }
}

TEST(PacerTest, aSourceThatIsTooSlowGivesWhatItCan) {
  PacedRun run(always(60));
  run.go();
  // Every other refresh, evenly; none of them late on the link or dropped.
  EXPECT_NEAR(static_cast<double>(run.display.shown.size()), 12 * kSeconds, 3);
  EXPECT_EQ(run.summary.framesShown, run.display.shown.size());
  EXPECT_EQ(run.count(RefreshOutcome::kLinkLate), 0u);
  EXPECT_EQ(run.count(RefreshOutcome::kSourceLate), run.summary.misses);
  EXPECT_LE(run.summary.latency.median, 60 + 5 + 3);
  // Of the first, before it is known how long it takes: it waits for the next refresh.
  EXPECT_LE(run.summary.latency.worst, 60 + 5 + kRefresh + 1);
}

TEST(PacerTest, twoStagesThatTakeLongerThanARefreshTogetherStillKeepUp) {
  PacedRun run(always(35));
  run.source.overlap(always(25));
  run.go();
  EXPECT_LE(run.summary.misses, 4u);
  EXPECT_GE(run.count(RefreshOutcome::kShown), 24 * kSeconds - 6);
  EXPECT_NEAR(run.summary.making.median, 60, 1);
  EXPECT_LE(run.summary.latency.median, 60 + 5 + 4);
  // Each is made for the time at which it is seen.
  for (const RefreshRecord& record : run.records) {
    if (record.frame > 10 && record.outcome == RefreshOutcome::kShown) {
      const auto error = record.shown - run.source.seen[record.frame - 1];
      EXPECT_NEAR(std::chrono::duration<double>(error).count(), 0, 1e-5) << record.frame;
    }
  }
}

TEST(PacerTest, aStageThatTakesLongerThanARefreshGivesWhatItCan) {
  for (const bool first : {false, true}) {
    PacedRun run(always(first ? 60 : 10));
    run.source.overlap(always(first ? 10 : 60));
    run.go();
    // One in 60 ms would be 16.7 a second; whole refreshes allow for 12 to 16.
    EXPECT_GE(run.display.shown.size(), 115u) << first;
    EXPECT_LE(run.summary.latency.median, 70 + 60 + 5 + kRefresh) << first;
  }
}

TEST(PacerTest, anOverlappedHiccupCostsItsRefreshesAndNoMore) {
  for (const double hiccup : {100.0, 200.0, 400.0}) {
    for (const bool first : {false, true}) {
      PacedRun run([&](int frame) { return first && frame == 100 ? hiccup : 25.0; });
      run.source.overlap([&](int frame) { return !first && frame == 100 ? hiccup : 25.0; });
      run.go();
      EXPECT_LE(static_cast<double>(run.summary.misses), std::ceil(hiccup / kRefresh) + 5) << hiccup;
    }
  }
}

TEST(PacerTest, aLinkThatIsTooSlowGetsEveryOtherFrameAndNothingPilesUp) {
  PacedRun run(always(10), {.linkMilliseconds = [](FrameNumber) { return 60.0; }});
  run.go();
  EXPECT_NEAR(static_cast<double>(run.display.shown.size()), 12 * kSeconds, 4);
  EXPECT_LE(run.count(RefreshOutcome::kSourceLate), 1u);  // nothing is known of the stages at first
  EXPECT_GE(run.count(RefreshOutcome::kLinkLate), 110u);
  // To be made and sent, and one refresh before it was known how long that takes.
  EXPECT_LE(run.summary.latency.worst, 10 + 60 + 2 * kRefresh);
  EXPECT_LE(run.summary.latency.median, 10 + 60 + 5);
}

TEST(PacerTest, aLinkThatSlowsDownIsFoundOut) {
  PacedRun run(always(10), {.linkMilliseconds = [](FrameNumber frame) { return frame < 100 ? 5.0 : 30.0; }});
  run.go();
  // Frames that were begun for the old link come late, and each is learned from.
  EXPECT_LE(run.summary.misses, 5u);
}

TEST(PacerTest, oneHiccupCostsTheRefreshesThatItTookAndNoMore) {
  for (const double hiccup : {100.0, 200.0, 400.0}) {
    PacedRun run([&](int frame) { return frame == 100 ? hiccup : 12.0; });
    run.go();
    EXPECT_GE(static_cast<double>(run.summary.misses), std::floor((hiccup - 12) / kRefresh));
    EXPECT_LE(static_cast<double>(run.summary.misses), std::ceil(hiccup / kRefresh) + 1);
  }
}

TEST(PacerTest, makingTimesThatVaryAreAllowedFor) {
  Random random(3);
  PacedRun run([&](int) { return static_cast<double>(random.inRange(5, 30)); });
  run.go();
  // After the first ones the lead covers more than the worst of them.
  EXPECT_LE(run.summary.misses, 4u);
  EXPECT_LE(run.summary.latency.worst, 30 + 5 + kRefresh);
}

TEST(PacerTest, framesOfWhichNothingIsHeardDoNotHoldBackWhatIsTold) {
  // From the 50th on nothing arrives, for 6 s; then the link is as before.
  PacedRun run(always(12), {.linkMilliseconds = [](FrameNumber frame) { return frame == 50 ? 6000.0 : 5.0; }});
  double longest = 0;
  size_t told = 0;
  run.go(kSeconds, [&](const RefreshRecord& record) {
    longest = std::max(longest, std::chrono::duration<double>(run.clock.now() - record.due).count());
    told = run.records.size();
  });
  // A second, and a look or two.
  EXPECT_LE(longest, 1.1);
  EXPECT_EQ(told, run.summary.refreshes);
  // Two frames are under way, none is added.
  EXPECT_NEAR(static_cast<double>(run.count(RefreshOutcome::kLinkLate)), 24 * 6, 6);
  // 50 before, and some after: what took so long is allowed for at first.
  EXPECT_GE(run.count(RefreshOutcome::kShown), 60u);
}

TEST(PacerTest, nothingIsMadeForADeviceThatIsNotThere) {
  PacedRun run(always(12));
  int goneAt = -1;
  run.source.after = [&](int frame) {
    if (frame == 50) {
      run.display.setConnected(false);
      goneAt = run.source.asked;
    }
  };
  const HostTime gone = run.clock.now() + std::chrono::seconds(3);
  HostTime back{};
  Pacer pacer(run.display, run.source, run.clock, {.seconds = kSeconds});
  run.summary = pacer.run([&] {
    if (goneAt > 0 && back == HostTime{} && run.clock.now() > gone + std::chrono::seconds(1)) {
      EXPECT_EQ(run.source.asked, goneAt);
      run.display.setConnected(true);
      back = run.clock.now();
    }
    return false;
  });
  EXPECT_NE(back, HostTime{});
  EXPECT_EQ(run.summary.misses, run.count(RefreshOutcome::kNotConnected) + run.count(RefreshOutcome::kSourceLate));
  EXPECT_NEAR(static_cast<double>(run.count(RefreshOutcome::kNotConnected)), 24 * 1.9, 3);  // from frame 50 to 4 s
  EXPECT_GE(run.count(RefreshOutcome::kShown), 24u * 7);
}

TEST(PacerTest, aRotationThatBeginsAnewIsFollowed) {
  PacedRun run(always(12));
  run.source.after = [&](int frame) {
    if (frame == 100) {
      run.display.restart();
    }
  };
  run.go();
  // Until the clock believes it: four readings, 5 ms apart at least.
  EXPECT_LE(run.summary.misses, 3u);
  EXPECT_GE(run.summary.refreshes, 230u);
}

TEST(PacerTest, aDeviceThatDoesNotTellItsRotationGetsFramesAtItsRate) {
  PacedRun run(always(12), {.tellsRotation = false});
  run.go();
  EXPECT_NEAR(static_cast<double>(run.display.shown.size()), 24 * kSeconds, 4);
  EXPECT_LE(run.summary.misses, 3u);
}

TEST(PacerTest, whatHasNotChangedIsNoMiss) {
  PacedRun run(always(12));
  run.source.same = [](int asked) { return asked % 3 != 0; };
  run.go();
  EXPECT_NEAR(static_cast<double>(run.display.shown.size()), 24 * kSeconds / 3, 2);
  EXPECT_NEAR(static_cast<double>(run.count(RefreshOutcome::kUnchanged)), 24 * kSeconds * 2 / 3, 4);
  EXPECT_LE(run.summary.misses, 1u);
}

TEST(PacerTest, theEndOfTheSourceEndsItAndTheLastFrameIsShown) {
  PacedRun run(always(12));
  run.source.ends = 30;
  run.go();
  EXPECT_EQ(run.display.shown.size(), 30u);
  EXPECT_EQ(run.summary.framesShown, 30u);
}

TEST(PacerTest, stopEndsIt) {
  PacedRun run(always(12));
  Pacer pacer(run.display, run.source, run.clock, {});
  const HostTime end = run.clock.now() + std::chrono::seconds(2);
  pacer.run([&] { return run.clock.now() >= end; });
  EXPECT_LE(run.clock.now(), end + std::chrono::milliseconds(100));
  EXPECT_NEAR(static_cast<double>(run.display.shown.size()), 48, 3);
}

/// Whatever goes wrong: refreshes come in order and none is left out, frames are told once, and latency is bounded.
TEST(PacerTest, theTimeLineIsWholeWhateverHappens) {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const auto some = [&](double most) { return static_cast<double>(random.inRange(0, static_cast<float>(most))); };
    const double usual = some(50);
    const double link = some(70);
    PacedRun run([&](int) { return random.below(20) == 0 ? some(300) : usual * (0.8 + some(0.4)); },
                 {.linkMilliseconds = [&](FrameNumber) { return random.below(20) == 0 ? some(200) : link; },
                  .rotationsPerMinute = 700 + some(40),
                  .tellsRotation = random.below(4) != 0});
    run.source.same = [&](int) { return random.below(10) == 0; };
    if (random.below(2) == 0) {
      run.source.overlap([&](int) { return random.below(20) == 0 ? some(300) : some(usual); });
    }
    size_t restarts = 0;
    size_t recounts = 0;
    run.source.after = [&](int) {
      if (random.below(200) == 0) {
        run.display.restart();
        ++restarts;
      }
    };
    run.go(4);
    std::set<FrameNumber> frames;
    for (size_t i = 0; i < run.records.size(); ++i) {
      const RefreshRecord& record = run.records[i];
      // A rotation that begins anew counts anew, nothing else does.
      recounts += i > 0 && record.refresh != run.records[i - 1].refresh + 1 ? 1 : 0;
      if (record.frame != 0) {
        EXPECT_TRUE(frames.insert(record.frame).second) << "seed " << seed;
        EXPECT_LE(record.makingBegan, record.makingEnded);
        EXPECT_LE(record.makingEnded, record.submitted);
      }
      EXPECT_EQ(record.outcome == RefreshOutcome::kShown, record.shown != HostTime{} && !record.late);
    }
    EXPECT_LE(recounts, 2 * restarts) << "seed " << seed;
    EXPECT_EQ(run.summary.refreshes, run.records.size());
    uint64_t sum = 0;
    for (const uint64_t count : run.summary.outcomes) {
      sum += count;
    }
    EXPECT_EQ(sum, run.summary.refreshes);
    // The worst of each stage and of those before it, two frames on the link, and a turn to wait.
    EXPECT_LE(run.summary.latency.worst, 3 * 300 + 2 * 200 + 3 * kRefresh) << "seed " << seed;
    EXPECT_GE(run.summary.framesShown, 10u) << "seed " << seed;
  }
}

}  // namespace
}  // namespace ocelli
