#include "study/screen/timing_check.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace ocelli {
namespace {

using testing::HasSubstr;

/// Times of frames with these intervals in milliseconds.
std::vector<int64_t> timesOf(const std::vector<double>& milliseconds) {
  std::vector<int64_t> times{1'000'000};
  for (const double interval : milliseconds) {
    times.push_back(times.back() + static_cast<int64_t>(std::round(interval * 1e6)));
  }
  return times;
}

std::vector<double> steady(int count, double milliseconds) {
  return std::vector<double>(static_cast<size_t>(count), milliseconds);
}

TimingCheck check(const std::vector<double>& milliseconds, int monitorHertz,
                  std::optional<double> wanted = std::nullopt) {
  TimingExpectation expected;
  expected.monitorHertz = monitorHertz;
  expected.wantedHertz = wanted;
  return checkTiming(measureTiming(timesOf(milliseconds), expected.limits.lateFactor), expected);
}

TEST(TimingCheck, measuresWhatWasMadeUp) {
  // 90 intervals of 10 ms, alternately 0.5 ms longer and shorter, and ten of 20 ms, which are late.
  std::vector<double> intervals;
  for (int i = 0; i < 90; ++i) {
    intervals.push_back(i % 2 == 0 ? 10.5 : 9.5);
  }
  for (int i = 0; i < 10; ++i) {
    intervals.push_back(20);
  }
  const TimingMeasurement measured = measureTiming(timesOf(intervals), 1.2);
  EXPECT_EQ(measured.intervals, 100);
  EXPECT_NEAR(measured.seconds, 1.1, 1e-9);
  EXPECT_NEAR(measured.hertz, 100, 1e-9);
  EXPECT_NEAR(measured.jitterShare, 0.05, 1e-9);
  EXPECT_NEAR(measured.lateShare, 0.1, 1e-9);
  EXPECT_NEAR(measured.longestMilliseconds, 20, 1e-9);
}

TEST(TimingCheck, measuresNothingOfNothing) {
  EXPECT_EQ(measureTiming({}, 1.2).intervals, 0);
  EXPECT_EQ(measureTiming(std::vector<int64_t>{5}, 1.2).hertz, 0);
  const TimingCheck none = checkTiming(measureTiming({}, 1.2), {.monitorHertz = 60});
  EXPECT_FALSE(none.isGood());
}

TEST(TimingCheck, takesASteadyScreen) {
  const TimingCheck good = check(steady(150, 1000.0 / 60), 60);
  EXPECT_TRUE(good.isGood()) << testing::PrintToString(good.problems);
  EXPECT_TRUE(good.verticalSync);
  EXPECT_EQ(refreshRateOf(good), 60);
  // 59.94 Hz, which monitors round to 60, is well within two hundredths.
  const TimingCheck nearly = check(steady(150, 1000.0 / 59.94), 60);
  EXPECT_TRUE(nearly.isGood());
  EXPECT_EQ(refreshRateOf(nearly), 60) << "the same for every session";
  EXPECT_TRUE(check(steady(150, 1000.0 / 144), 144, 144.0).isGood());
}

TEST(TimingCheck, allowsOneLateFrameInAHundred) {
  std::vector<double> intervals = steady(200, 1000.0 / 60);
  intervals[50] *= 2;
  intervals[150] *= 2;
  EXPECT_TRUE(check(intervals, 60).isGood());
  intervals[100] *= 2;
  const TimingCheck late = check(intervals, 60);
  ASSERT_EQ(late.problems.size(), 1u);
  EXPECT_THAT(late.problems[0], HasSubstr("1.5 % of the frames come late"));
  EXPECT_FALSE(late.advice.empty());
}

TEST(TimingCheck, refusesFramesThatWaitForNothing) {
  const TimingCheck fast = check(steady(4000, 0.4), 60);
  EXPECT_FALSE(fast.verticalSync);
  ASSERT_EQ(fast.problems.size(), 1u);
  EXPECT_THAT(fast.problems[0], testing::AllOf(HasSubstr("do not wait"), HasSubstr("2.5 kHz")));
  EXPECT_THAT(fast.advice[0], HasSubstr("vblank_mode"));
}

TEST(TimingCheck, refusesAScreenWithoutARate) {
  const TimingCheck virtualScreen = check(steady(500, 5), 0);
  EXPECT_FALSE(virtualScreen.verticalSync);
  ASSERT_EQ(virtualScreen.problems.size(), 1u);
  EXPECT_THAT(virtualScreen.problems[0], HasSubstr("200.00 Hz"));
  // The protocol may know it.
  EXPECT_TRUE(check(steady(500, 5), 0, 200.0).isGood());
  EXPECT_FALSE(check(steady(500, 5), 0, 60.0).verticalSync);
}

TEST(TimingCheck, refusesAnotherRateThanIsSaid) {
  const TimingCheck other = check(steady(150, 1000.0 / 50), 60);
  ASSERT_EQ(other.problems.size(), 1u);
  EXPECT_THAT(other.problems[0], testing::AllOf(HasSubstr("60 Hz"), HasSubstr("50.00 Hz")));
  EXPECT_EQ(refreshRateOf(other), 50);
  const TimingCheck unwanted = check(steady(150, 1000.0 / 60), 60, 120.0);
  ASSERT_EQ(unwanted.problems.size(), 1u);
  EXPECT_THAT(unwanted.problems[0], testing::AllOf(HasSubstr("protocol"), HasSubstr("120 Hz")));
}

TEST(TimingCheck, refusesUnevenFrames) {
  std::vector<double> intervals;
  for (int i = 0; i < 150; ++i) {
    intervals.push_back(1000.0 / 60 * (i % 2 == 0 ? 1.15 : 0.85));  // deviate by 0.15, and none is late
  }
  const TimingCheck uneven = check(intervals, 60);
  ASSERT_EQ(uneven.problems.size(), 1u);
  EXPECT_THAT(uneven.problems[0], HasSubstr("15.0 %"));
}

TEST(TimingCheck, refusesAFewFrames) {
  EXPECT_THAT(check(steady(20, 1000.0 / 60), 60).problems, testing::ElementsAre(HasSubstr("only 21 frames")));
}

TEST(TimingCheck, isStoredWhole) {
  const auto json = nlohmann::json::parse(jsonText(check(steady(4000, 0.4), 60)));
  EXPECT_EQ(json.at("verdict"), "refused");
  EXPECT_EQ(json.at("vertical_sync"), false);
  EXPECT_NEAR(json.at("measured").at("hertz").get<double>(), 2500, 1e-6);
  EXPECT_EQ(json.at("expected").at("monitor_hertz"), 60);
  EXPECT_TRUE(json.at("expected").at("protocol_hertz").is_null());
  EXPECT_EQ(nlohmann::json::parse(jsonText(check(steady(150, 1000.0 / 60), 60))).at("verdict"), "good");
}

}  // namespace
}  // namespace ocelli
