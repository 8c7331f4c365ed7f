#include "oc_core/evaluation/image_quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/image/image_error.h"
#include "tests/evaluation/test_images.h"

namespace ocelli {
namespace {

using test::plain;

/// The definition, window by window, in double precision.
double slowSsim(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  const auto luma = [](const Image<Rgb8>& image, int x, int y) {
    const Rgb8& c = image(std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
    return 0.299 * c.x + 0.587 * c.y + 0.114 * c.z;
  };
  double total = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      double sum = 0, meanA = 0, meanB = 0, aa = 0, bb = 0, ab = 0;
      for (int v = -5; v <= 5; ++v) {
        for (int u = -5; u <= 5; ++u) {
          const double weight = std::exp(-(u * u + v * v) / (2 * 1.5 * 1.5));
          const double p = luma(a, x + u, y + v);
          const double q = luma(b, x + u, y + v);
          sum += weight;
          meanA += weight * p;
          meanB += weight * q;
          aa += weight * p * p;
          bb += weight * q * q;
          ab += weight * p * q;
        }
      }
      meanA /= sum;
      meanB /= sum;
      const double varianceA = aa / sum - meanA * meanA;
      const double varianceB = bb / sum - meanB * meanB;
      const double covariance = ab / sum - meanA * meanB;
      const double c1 = std::pow(0.01 * 255, 2);
      const double c2 = std::pow(0.03 * 255, 2);
      total += (2 * meanA * meanB + c1) * (2 * covariance + c2) /
               ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2));
    }
  }
  return total / static_cast<double>(a.size());
}

TEST(Ssim, isItsDefinition) {
  for (const auto& [width, height] : {std::pair(40, 25), {7, 5}, {1, 1}, {1, 30}}) {
    const Image<Rgb8> a = test::randomImage(width, height, 1);
    const Image<Rgb8> b = test::withNoise(a, 60);
    // Variances are small differences of squares up to 65025, with 24 bits: 0.01 of a c2 of 58.5.
    EXPECT_NEAR(ssim(a, b), slowSsim(a, b), 1e-3) << width << "x" << height;
  }
}

TEST(Ssim, ofPlainImagesIsThatOfTheirLuminance) {
  const double c1 = 6.5025;
  EXPECT_NEAR(ssim(plain({0, 0, 0}), plain({255, 255, 255})), c1 / (255 * 255 + c1), 1e-6);
  EXPECT_NEAR(ssim(plain({100, 100, 100}), plain({50, 50, 50})), (2 * 5000 + c1) / (12500 + c1), 1e-4);
  EXPECT_NEAR(ssim(plain({9, 90, 9}), plain({9, 90, 9})), 1, 1e-6);
}

TEST(Ssim, isSymmetricAndFallsUnderGrowingNoise) {
  const Image<Rgb8> picture = test::gradient();
  double last = 1.0001;
  for (const int amplitude : {0, 5, 10, 20, 40, 80}) {
    const Image<Rgb8> noisy = test::withNoise(picture, amplitude);
    const double similarity = ssim(picture, noisy);
    EXPECT_LT(similarity, last) << amplitude;
    EXPECT_EQ(similarity, ssim(noisy, picture));
    last = similarity;
  }
}

TEST(ImageQualityDeathTest, wantsImagesOfOneSize) {
  EXPECT_DEATH(ssim(plain({0, 0, 0}, 4, 4), plain({0, 0, 0}, 4, 5)), "same size");
  EXPECT_DEATH(meanSquaredError({}, {}), "pixels");
}

}  // namespace
}  // namespace ocelli
