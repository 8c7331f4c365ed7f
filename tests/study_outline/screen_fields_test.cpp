#include "study/outline/screen_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/study_outline/outline_text.h"

namespace ocelli::test {
namespace {

constexpr ProtocolReading kStrictly = ProtocolReading::kByStudy;
constexpr ProtocolReading kLeniently = ProtocolReading::kByAnalysis;

TEST(ScreenFields, AreTheSameToBoth) {
  for (const ProtocolReading reading : kBothReadings) {
    const StatedScreen screen =
        readOutline(R"({"screen": {"distance_millimeters": 700, "refresh_hertz": 60}})", reading, readStatedScreen);
    EXPECT_EQ(screen.distanceMillimeters, 700);
    EXPECT_EQ(screen.refreshHertz, 60);
    EXPECT_FALSE(screen.widthMillimeters);
    EXPECT_FALSE(readOutline("{}", reading, readStatedScreen).distanceMillimeters);
    EXPECT_EQ(readOutline(R"({"timing": {"late_factor": 1.5}})", reading, readTimingLimits).lateFactor, 1.5);
    EXPECT_EQ(readOutline("{}", reading, readTimingLimits).lateFactor, 1.2);
  }
}

TEST(ScreenFields, AreStrictToAStudyAlone) {
  for (const char* text : {R"({"screen": {"distance_millimeters": 1}})", R"({"screen": {"least_width": "wide"}})",
                           R"({"screen": {"depth_millimeters": 1}})"}) {
    EXPECT_NE(outlineErrorOf(text, kStrictly, readStatedScreen), "") << text;
    EXPECT_EQ(outlineErrorOf(text, kLeniently, readStatedScreen), "") << text;
  }
  for (const char* text : {R"({"timing": {"late_factor": 20}})", R"({"timing": {"most_jitter_share": 20}})",
                           R"({"timing": {"early_factor": 2}})"}) {
    EXPECT_NE(outlineErrorOf(text, kStrictly, readTimingLimits), "") << text;
    EXPECT_EQ(outlineErrorOf(text, kLeniently, readTimingLimits), "") << text;
  }
}

}  // namespace
}  // namespace ocelli::test
