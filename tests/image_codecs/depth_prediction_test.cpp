#include "oc_core/image_codecs/depth_prediction.h"

#include <gtest/gtest.h>

#include "tests/image_codecs/coded_samples.h"

namespace ocelli {
namespace {

using namespace test;

TEST(DepthPrediction, TakesTheSlopeOrOneSideOfAnEdge) {
  EXPECT_EQ(medianPrediction(10, 20, 12), 18);  // between: a + b - c
  EXPECT_EQ(medianPrediction(10, 20, 25), 10);
  EXPECT_EQ(medianPrediction(10, 20, 5), 20);
  EXPECT_EQ(medianPrediction(20, 10, 20), 10);
}

TEST(DepthPrediction, ResidualsAreThoseOfTheProtocol) {
  // 100 103
  //  90  96: predicted 0, 100, 100, 93; left 100, 3, -10, 3; folded 200, 6, 19, 6. High bytes first.
  Image<uint16_t> image(2, 2);
  image[0] = 100;
  image[1] = 103;
  image[2] = 90;
  image[3] = 96;
  const std::vector<std::byte> expected{std::byte{0},   std::byte{0}, std::byte{0},  std::byte{0},
                                        std::byte{200}, std::byte{6}, std::byte{19}, std::byte{6}};
  EXPECT_EQ(depthResiduals(image), expected);
  EXPECT_EQ(depthFromResiduals(expected, {2, 2}), image);
}

TEST(DepthPrediction, OfAPlaneNoMoreIsLeftThanTheSmallerSlope) {
  for (const int down : {5, -5}) {
    Image<uint16_t> plane(40, 30);
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        plane(x, y) = static_cast<uint16_t>(1000 + 17 * x + down * y);
      }
    }
    // Falling down and rising to the right, c lies between a and b: exact. Rising along both, c is the least of the
    // three and b, the larger, is taken: 5 too little, stored as 2 * 5 - and as nothing else.
    const std::byte left = down > 0 ? std::byte{10} : std::byte{0};
    const std::vector<std::byte> residuals = depthResiduals(plane);
    for (int y = 1; y < 30; ++y) {
      for (int x = 1; x < 40; ++x) {
        EXPECT_EQ(residuals[plane.index(x, y)], std::byte{0});
        EXPECT_EQ(residuals[plane.size() + plane.index(x, y)], left);
      }
    }
  }
}

TEST(DepthPrediction, AnyValuesComeBack) {
  for (const Image<uint16_t>& image : {depthNoise(33, 21), depthOfDisc(64, 40), depthNoise(1, 9), depthNoise(9, 1)}) {
    EXPECT_EQ(depthFromResiduals(depthResiduals(image), {image.width(), image.height()}), image);
  }
}

}  // namespace
}  // namespace ocelli
