#include "study/replay/gaze_trail.h"

#include <gtest/gtest.h>

namespace ocelli::test {
namespace {

constexpr int64_t kTenth = 100'000'000;  // nanoseconds

GazeRecord seen(int64_t nanoseconds, double x, double y) {
  return {nanoseconds, 0, true, x, y, {}};
}

TEST(GazeTrail, IsOfTheLastThreeTenthsOfASecond) {
  const std::vector<GazeRecord> samples{seen(0, 1, 1), seen(2 * kTenth, 2, 2), seen(3 * kTenth, 3, 3),
                                        seen(4 * kTenth, 4, 4), seen(9 * kTenth, 9, 9)};
  const std::vector<GazeMark> marks = gazeTrail(samples, 4 * kTenth + kTenth / 2);
  ASSERT_EQ(marks.size(), 3u);
  EXPECT_EQ(marks.back().place.x, 4) << "the newest last, and none that is yet to come";
  EXPECT_NEAR(marks.back().age, 0.5 / 3, 1e-12);
  EXPECT_NEAR(marks.front().age, 2.5 / 3, 1e-12);
  EXPECT_TRUE(gazeTrail(samples, -1).empty());
  EXPECT_TRUE(gazeTrail(samples, 8 * kTenth).empty()) << "all too old";
  EXPECT_TRUE(gazeTrail({}, 0).empty());
}

TEST(GazeTrail, BreaksOffWhereNothingWasSeen) {
  std::vector<GazeRecord> samples{seen(0, 1, 1), {kTenth, 0, false, 0, 0, {}}, seen(2 * kTenth, 3, 3)};
  const std::vector<GazeMark> marks = gazeTrail(samples, 2 * kTenth);
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_FALSE(marks[1].joined) << "what lies between was not seen";
  samples[1].valid = true;
  EXPECT_TRUE(gazeTrail(samples, 2 * kTenth)[1].joined);
  samples[1].valid = false;
  EXPECT_TRUE(gazeTrail(samples, kTenth).empty()) << "the eye is closed";
}

double luminanceAt(const Image<Rgb8>& image, double x, double y) {
  const Rgb8 pixel = image(static_cast<int>(x), static_cast<int>(y));
  return (pixel[0] + pixel[1] + pixel[2]) / 3.0;
}

/// The ring is white with dark on both sides, whatever is below it.
TEST(GazeTrail, StandsOutFromBrightAndDarkScenes) {
  for (const int ground : {0, 128, 255}) {
    Image<Rgb8> image(200, 100);
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 200; ++x) {
        image(x, y) = Rgb8(static_cast<uint8_t>(ground));
      }
    }
    const std::vector<GazeMark> marks{{{40, 50}, 1}, {{100, 50}, 0}};
    drawGaze(image, marks);
    const double right = 100 + kGazeRadius;
    EXPECT_EQ(luminanceAt(image, right, 50), 255) << ground;
    EXPECT_LT(luminanceAt(image, right + 2.4, 50), 60) << ground;
    EXPECT_LT(luminanceAt(image, right - 2.6, 50), 60) << ground;
    EXPECT_GT(luminanceAt(image, 70, 50), 200) << "the trail, " << ground;
    EXPECT_EQ(luminanceAt(image, 150, 50), ground) << "nothing else is touched";
    EXPECT_EQ(luminanceAt(image, 70, 20), ground);
  }
}

TEST(GazeTrail, MayLieBesideTheImage) {
  Image<Rgb8> image(20, 20);
  for (const GazeMark& mark : {GazeMark{{-1000, 5}, 0}, GazeMark{{1e6, 1e6}, 0}, GazeMark{{-1e6, -1e6}, 0}}) {
    const std::vector<GazeMark> marks{{{10, 10}, 0.5}, mark};
    EXPECT_NO_THROW(drawGaze(image, marks));
  }
}

}  // namespace
}  // namespace ocelli::test
