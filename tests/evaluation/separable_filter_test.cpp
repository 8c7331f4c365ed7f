#include "oc_core/evaluation/separable_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace ocelli {
namespace {

Image<float> noise(int width, int height) {
  std::mt19937 random(1);
  Image<float> image(width, height);
  for (float& value : image) {
    value = static_cast<float>(random() >> 8) / static_cast<float>(1 << 24);
  }
  return image;
}

/// The definition, pixel by pixel.
float filteredAt(const Image<float>& image, const Kernel& kernel, int x, int y, int stepX, int stepY) {
  const int radius = static_cast<int>(kernel.size() / 2);
  float sum = 0;
  for (int i = -radius; i <= radius; ++i) {
    sum += kernel[static_cast<size_t>(i + radius)] *
           image(std::clamp(x + i * stepX, 0, image.width() - 1), std::clamp(y + i * stepY, 0, image.height() - 1));
  }
  return sum;
}

TEST(SeparableFilter, isItsDefinition) {
  const Kernel kernel{0.5f, -1, 2, 3, 0.25f};
  for (const auto& [width, height] : {std::pair(33, 21), {1, 9}, {9, 1}, {1, 1}, {2, 2}}) {
    const Image<float> image = noise(width, height);
    const Image<float> rows = filterRows(image, kernel);
    const Image<float> columns = filterColumns(image, kernel);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        // Up to five sums of numbers below 5, rounded in another order.
        EXPECT_NEAR(rows(x, y), filteredAt(image, kernel, x, y, 1, 0), 5e-6f);
        EXPECT_NEAR(columns(x, y), filteredAt(image, kernel, x, y, 0, 1), 5e-6f);
      }
    }
  }
}

TEST(SeparableFilter, aKernelOfOneScales) {
  const Image<float> image = noise(5, 4);
  const Image<float> doubled = filterColumns(image, {2});
  for (size_t i = 0; i < image.size(); ++i) {
    EXPECT_EQ(doubled[i], 2 * image[i]);
  }
}

TEST(SeparableFilter, anEmptyImageStaysEmpty) {
  EXPECT_TRUE(filterRows({}, {1}).empty());
  EXPECT_TRUE(filterColumns({}, {1}).empty());
}

TEST(GaussianKernel, sumsToOneAndFallsAsAGaussian) {
  const Kernel kernel = gaussianKernel(1.5f, 5);
  ASSERT_EQ(kernel.size(), 11u);
  float sum = 0;
  for (size_t i = 0; i < kernel.size(); ++i) {
    sum += kernel[i];
    EXPECT_EQ(kernel[i], kernel[kernel.size() - 1 - i]);
  }
  EXPECT_NEAR(sum, 1, 1e-6f);
  EXPECT_NEAR(kernel[8] / kernel[5], std::exp(-2.0f), 1e-6f) << "two sigma from the middle";
}

}  // namespace
}  // namespace ocelli
