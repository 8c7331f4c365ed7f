#include "display_sim/viewer/effect_difference.h"

#include <gtest/gtest.h>

#include "display_sim/viewer/viewer_colors.h"

namespace ocelli {
namespace {

Rgb8 colorOf(const GuiColor& color) {
  return {color.red, color.green, color.blue};
}

TEST(EffectDifference, equalPicturesDifferNowhere) {
  const Image<Rgb8> picture(3, 2, Rgb8(10, 20, 30));
  const EffectDifference difference = differenceOf(picture, picture);
  EXPECT_EQ(difference.pixels, 6U);
  EXPECT_EQ(difference.different, 0U);
  EXPECT_EQ(difference.clearlyDifferent, 0U);
  EXPECT_TRUE(std::isinf(difference.psnrDecibels));
  EXPECT_EQ(difference.heat, Image<Rgb8>(3, 2, dimmedGrey({10, 20, 30})));
}

TEST(EffectDifference, countsTheLargestChannelOfEachPixel) {
  const Image<Rgb8> traced(4, 1, Rgb8(100, 100, 100));
  Image<Rgb8> picture = traced;
  picture[1] = {100, 101, 98};                          // by 2
  picture[2] = {100 - kClearDifference, 100, 100};      // as much as is not clear yet
  picture[3] = {100, 100, 100 + kClearDifference + 1};  // clear
  const EffectDifference difference = differenceOf(picture, traced);
  EXPECT_EQ(difference.different, 3U);
  EXPECT_EQ(difference.clearlyDifferent, 1U);
  EXPECT_EQ(difference.clearShare(), 0.25);
  EXPECT_EQ(difference.heat[0], dimmedGrey({100, 100, 100}));
  EXPECT_EQ(difference.heat[1], heatOf(2));
  EXPECT_EQ(difference.heat[3], heatOf(kClearDifference + 1));
}

TEST(EffectDifference, heatRunsFromDarkToLightAndStaysThere) {
  EXPECT_EQ(heatOf(0), colorOf(kRampDark));
  EXPECT_EQ(heatOf(kHottestDifference), colorOf(kRampLight));
  EXPECT_EQ(heatOf(255), colorOf(kRampLight));
  for (int difference = 1; difference <= kHottestDifference; ++difference) {
    EXPECT_GT(heatOf(difference).y, heatOf(difference - 1).y) << difference;  // seen without colours, too
  }
}

TEST(EffectDifference, whatIsAsTracedIsDarkerThanAnyHeat) {
  const auto luma = [](const Rgb8& color) { return 299 * color.x + 587 * color.y + 114 * color.z; };
  EXPECT_LE(luma(dimmedGrey({255, 255, 255})), luma(heatOf(0)));
  EXPECT_LT(luma(dimmedGrey({0, 100, 0})), luma(dimmedGrey({200, 200, 0})));
}

}  // namespace
}  // namespace ocelli
