#include "oc_core/antialiasing/sample_positions.h"

#include <gtest/gtest.h>

#include <set>

namespace ocelli {
namespace {

TEST(SamplePositions, eachStratumHasOneSampleWithinItsBounds) {
  for (const SamplePlacement& placement : samplePlacements()) {
    for (const int n : {1, 3, 8, 32}) {
      const SamplePattern pattern(n, placement);
      for (const glm::ivec2 pixel : {glm::ivec2(0, 0), {17, 5}, {1279, 719}}) {
        const std::span<const float> u = pattern.u(pixel.x, pixel.y);
        const std::span<const float> v = pattern.v(pixel.x, pixel.y);
        ASSERT_EQ(u.size(), static_cast<size_t>(n) * static_cast<size_t>(n));
        for (int k = 0; k < n; ++k) {
          for (int i = 0; i < n; ++i) {
            const auto index = static_cast<size_t>(k * n + i);
            // Single precision: 1e-6 of a pixel is far more than its rounding.
            EXPECT_NEAR(u[index], (static_cast<float>(i) + 0.5f) / static_cast<float>(n),
                        0.5f / static_cast<float>(n) + 1e-6f);
            EXPECT_NEAR(v[index], (static_cast<float>(k) + 0.5f) / static_cast<float>(n),
                        0.5f / static_cast<float>(n) + 1e-6f);
            EXPECT_LT(u[index], 1);
            EXPECT_LT(v[index], 1);
            EXPECT_GE(u[index] * static_cast<float>(n) - static_cast<float>(i), pattern.leastInStratum() - 1e-5f);
            EXPECT_LE(u[index] * static_cast<float>(n) - static_cast<float>(i), pattern.greatestInStratum() + 1e-5f);
          }
        }
      }
    }
  }
}

TEST(SamplePositions, someGiveEachSampleARowAndAColumnOfItsOwn) {
  const auto rowsAndColumns = [](const char* placement, int n) {
    const SamplePattern pattern(n, *findSamplePlacement(placement));
    std::set<int> columns;
    std::set<int> rows;
    for (const float u : pattern.u(5, 6)) {
      columns.insert(static_cast<int>(u * static_cast<float>(n * n)));
    }
    for (const float v : pattern.v(5, 6)) {
      rows.insert(static_cast<int>(v * static_cast<float>(n * n)));
    }
    return std::pair(rows.size(), columns.size());
  };
  for (const size_t n : {size_t{5}, size_t{8}, size_t{16}}) {
    const std::pair all(n * n, n * n);
    EXPECT_EQ(rowsAndColumns("sheared", static_cast<int>(n)), all);
    EXPECT_EQ(rowsAndColumns("slanted", static_cast<int>(n)), all);
    EXPECT_EQ(rowsAndColumns("multijittered", static_cast<int>(n)), all);
    EXPECT_EQ(rowsAndColumns("grid", static_cast<int>(n)), std::pair(n, n));
  }
}

TEST(SamplePositions, jitterDiffersBetweenPixelsAndIsTheSameEachTime) {
  const SamplePattern pattern(4, *findSamplePlacement("jittered"));
  const SamplePattern again(4, *findSamplePlacement("jittered"));
  std::set<float> first;
  for (int x = 0; x < 32; ++x) {
    first.insert(pattern.u(x, 9)[0]);
    EXPECT_EQ(pattern.u(x, 9)[0], again.u(x, 9)[0]);
  }
  EXPECT_GT(first.size(), 16U);  // of 64 patterns, 32 draws give about 25 different ones
}

TEST(SamplePositions, multisamplingHasARowAndAColumnForEachSample) {
  for (const int samples : {2, 4, 8, 16}) {
    std::set<int> columns;
    std::set<int> rows;
    for (const glm::ivec2& each : multisamplePositions(samples)) {
      columns.insert(each.x);
      rows.insert(each.y);
    }
    EXPECT_EQ(columns.size(), static_cast<size_t>(samples));
    EXPECT_EQ(rows.size(), static_cast<size_t>(samples));
    EXPECT_EQ(SamplePattern::multisample(samples).size(), samples);
  }
  EXPECT_TRUE(multisamplePositions(3).empty());
}

}  // namespace
}  // namespace ocelli
