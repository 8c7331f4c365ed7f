#include "oc_core/focus/rate_heat.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

constexpr RateRange kRange{0.25, 4};

int brightness(const Rgb8& color) {
  return color.x + color.y + color.z;
}

TEST(RateHeat, moreIsDarkerOnAScaleOfEqualFactors) {
  int last = 766;
  for (const double rate : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    const int now = brightness(rateColor(rate, kRange));
    EXPECT_LT(now, last) << rate;
    last = now;
  }
  EXPECT_EQ(rateColor(0.1, kRange), rateColor(0.25, kRange)) << "beyond its ends";
  EXPECT_EQ(rateColor(9, kRange), rateColor(4, kRange));
  EXPECT_EQ(rateColor(2, {1, 1}), rateColor(1, {1, 1})) << "a range without extent";
}

TEST(RateHeat, thePictureShowsThroughByItsBrightness) {
  Image<float> rates(2, 1);
  rates(0, 0) = rates(1, 0) = 1;
  Image<Rgb8> picture(2, 1);
  picture(1, 0) = {255, 255, 255};
  const Image<Rgb8> heat = rateHeat(rates, kRange, picture);
  EXPECT_LT(brightness(heat(0, 0)), brightness(heat(1, 0)));
  const Rgb8 plain = rateHeat(rates, kRange, {})(0, 0);
  EXPECT_EQ(heat(1, 0), plain) << "white changes nothing";
  EXPECT_LE(std::abs(brightness(plain) - brightness(rateColor(1, kRange))), 3) << "a step of the table's colours";
}

}  // namespace
}  // namespace ocelli
