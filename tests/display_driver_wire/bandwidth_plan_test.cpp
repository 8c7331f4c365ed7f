#include "display_driver/wire/bandwidth_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"

namespace ocelli::wire {
namespace {

constexpr double kHeader = 32;
constexpr PlannedLink (*kLink)(const std::string&) = plannedLink;

DisplayProfile smallDisplay() {
  DisplayProfile profile = loadProfile("test");
  profile.slicesPerHalfTurn = 20;
  return profile;
}

/// FRAME_BEGIN with a bit for each of 20 slices, FRAME_END, PRESENT: their headers and payloads.
constexpr double kFrameBytes = kHeader + 8 + 3 + kHeader + 8 + kHeader + 12;

TEST(PlannedLink, KnowsItsNamesAndNumbers) {
  EXPECT_EQ(kLink("usb2").bytesPerSecond, 40e6);
  EXPECT_EQ(kLink("usb3").bytesPerSecond, 400e6);
  EXPECT_EQ(kLink("25e6").bytesPerSecond, 25e6);
  for (const char* wrong : {"", "usb4", "0", "-3", "1e30", "nan", "12 MB", "inf"}) {
    EXPECT_THROW(kLink(wrong), InputError) << wrong;
  }
}

TEST(BandwidthPlanner, CountsEveryByteOfAFrame) {
  Volume volume(smallDisplay());
  for (const int slice : {3, 4, 19}) {
    volume.light(slice, 5, 6, 7);
  }
  BandwidthPlanner planner;
  planner.add(volume);
  const std::vector<CodingPlan> plans = planner.plans();
  ASSERT_EQ(plans.size(), 3u);
  for (const CodingPlan& plan : plans) {
    EXPECT_FALSE(plan.changes);
    EXPECT_EQ(plan.slices, 3);
    EXPECT_EQ(plan.overheadBytes, kFrameBytes + 3 * kHeader);
    EXPECT_GT(plan.codingSeconds, 0);
  }
  // Three planes of 64 rows of 8 bytes.
  EXPECT_EQ(plans[0].coding, Coding::kRaw);
  EXPECT_EQ(plans[0].payloadBytes, 3.0 * 3 * 64 * 8);
  EXPECT_EQ(plans[1].coding, Coding::kRunLength);
  EXPECT_LT(plans[1].payloadBytes, plans[0].payloadBytes / 10);
  EXPECT_EQ(plans[2].coding, Coding::kZstd);
  EXPECT_LT(plans[2].payloadBytes, plans[0].payloadBytes / 10);
}

TEST(BandwidthPlanner, ChangesAreThoseToTheFrameBefore) {
  Volume volume(smallDisplay());
  for (int slice = 0; slice < 20; ++slice) {
    volume.light(slice, 5, 6, 7);
  }
  BandwidthPlanner planner;
  planner.add(volume);
  planner.add(volume);
  volume.light(7, 30, 30, 1);
  planner.add(volume);
  const std::vector<CodingPlan> plans = planner.plans();
  ASSERT_EQ(plans.size(), 6u);
  EXPECT_EQ(plans[0].slices, 20);
  for (size_t i = 3; i < 6; ++i) {
    EXPECT_TRUE(plans[i].changes);
    // Nothing, then one slice.
    EXPECT_EQ(plans[i].slices, 0.5);
    EXPECT_EQ(plans[i].overheadBytes, kFrameBytes + kHeader / 2);
  }
  EXPECT_EQ(plans[3].payloadBytes, 3.0 * 64 * 8 / 2);
}

CodingPlan planOf(double payload, double overhead, double seconds) {
  return {.payloadBytes = payload, .overheadBytes = overhead, .codingSeconds = seconds};
}

TEST(CodingPlan, KnowsWhatLimitsIt) {
  const PlannedLink link{"", 1000};
  EXPECT_EQ(planOf(40, 10, 0.02).hertz(link), 20);
  EXPECT_EQ(planOf(40, 10, 0.02).limit(link, 20), PlanLimit::kNone);
  EXPECT_EQ(planOf(51, 10, 0.02).limit(link, 20), PlanLimit::kLink);
  EXPECT_EQ(planOf(45, 10, 0.02).limit(link, 20), PlanLimit::kOverhead);
  EXPECT_EQ(planOf(40, 10, 0.1).hertz(link), 10);
  EXPECT_EQ(planOf(40, 10, 0.1).limit(link, 20), PlanLimit::kCoding);
}

TEST(CodingPlan, TheBestReachesTheRateWithFewBytes) {
  const PlannedLink link{"", 1000};
  const std::vector<CodingPlan> plans{planOf(90, 10, 0.001), planOf(40, 0, 0.03), planOf(20, 0, 0.2)};
  EXPECT_EQ(&bestPlan(plans, link, 20), &plans[1]);
  EXPECT_EQ(&bestPlan(plans, link, 5), &plans[2]);
  EXPECT_EQ(&bestPlan(plans, link, 50), &plans[1]) << "none reaches it: the fastest";
}

}  // namespace
}  // namespace ocelli::wire
