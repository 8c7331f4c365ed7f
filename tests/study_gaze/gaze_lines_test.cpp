#include "study/gaze/gaze_lines.h"

#include <gtest/gtest.h>

#include <string>

namespace ocelli::test {
namespace {

GazeLines inPixels() {
  return {GazeUnit::kPixels, 1920, 1200};
}

TEST(GazeLines, ReadsSeveralLinesOfADatagram) {
  GazeLines lines = inPixels();
  const std::vector<GazeRecord> samples =
      lines.read("1042.5,960,600.25,1,3.4\r\n1043.5,961,601,1\n\n1044.5,0,0,0,", 77);
  ASSERT_EQ(samples.size(), 3u);
  EXPECT_EQ(samples[0], (GazeRecord{77, 1042.5, true, 960, 600.25, 3.4}));
  EXPECT_EQ(samples[1], (GazeRecord{77, 1043.5, true, 961, 601, {}}));
  EXPECT_EQ(samples[2], (GazeRecord{77, 1044.5, false, 0, 0, {}}));
  EXPECT_EQ(lines.malformed(), 0);
}

TEST(GazeLines, TakesSharesForPixelsOfTheScreen) {
  GazeLines lines(GazeUnit::kShares, 1920, 1200);
  const std::vector<GazeRecord> samples = lines.read("1,0.25,0.5,1\n2,-0.1,1.5,1", 0);
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_DOUBLE_EQ(samples[0].x, 480);
  EXPECT_DOUBLE_EQ(samples[0].y, 600);
  EXPECT_DOUBLE_EQ(samples[1].x, -192) << "beside the screen";
  EXPECT_DOUBLE_EQ(samples[1].y, 1800);
}

TEST(GazeLines, FollowsALineOfNames) {
  GazeLines lines = inPixels();
  const std::vector<GazeRecord> samples = lines.read(
      "valid, pupil, y_norm, other, x_norm, time\n1,2.5,0.5,abc,0.25,9\ntime,x_px,y_px,valid\n10,5,6,true", 0);
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0], (GazeRecord{0, 9, true, 480, 600, 2.5}));
  EXPECT_EQ(samples[1], (GazeRecord{0, 10, true, 5, 6, {}}));
  EXPECT_EQ(lines.malformed(), 0);
}

TEST(GazeLines, NeedsNoPlaceWhereNothingWasSeen) {
  GazeLines lines = inPixels();
  const std::vector<GazeRecord> samples = lines.read("1,nan,nan,0,nan\n2,,,0\n3,-1e300,5,false", 0);
  ASSERT_EQ(samples.size(), 3u);
  for (const GazeRecord& sample : samples) {
    EXPECT_FALSE(sample.valid);
    EXPECT_EQ(sample.x, 0);
    EXPECT_FALSE(sample.pupil.has_value());
  }
  EXPECT_EQ(lines.malformed(), 0);
}

TEST(GazeLines, CountsWhatIsMalformedAndGoesOn) {
  const std::string tooLong(GazeLines::kMaxLineBytes + 1, '1');
  std::string tooMany = "1,2,3,1";
  for (size_t i = 0; i < GazeLines::kMaxColumns; ++i) {
    tooMany += ",0";
  }
  for (const std::string& bad :
       {std::string("hello"), std::string("1,2,3"), std::string("1,2,3,2"), std::string("1,nan,3,1"),
        std::string("inf,2,3,1"), std::string("1,2,3,1,big"), std::string("1,2e9,3,1"), std::string("1;2;3;1"),
        std::string("time,x_px,y_px"), std::string("time,x_px,y_px,x_norm,y_norm,valid"), std::string("1,0x10,3,1"),
        std::string("1,2,3,1\0", 8), tooLong, tooMany}) {
    GazeLines lines = inPixels();
    const std::vector<GazeRecord> samples = lines.read(bad + "\n7,1,2,1\n", 0);
    EXPECT_EQ(lines.malformed(), 1) << bad;
    ASSERT_EQ(samples.size(), 1u) << bad;
    EXPECT_EQ(samples[0].deviceTime, 7);
  }
}

TEST(GazeLines, PassesCommentsOver) {
  GazeLines lines = inPixels();
  EXPECT_TRUE(lines.read("# tracker 3\n  \r\n", 0).empty());
  EXPECT_EQ(lines.malformed(), 0);
}

}  // namespace
}  // namespace ocelli::test
