#include "oc_core/camera/displacement_bounds.h"

#include <gtest/gtest.h>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

/// Displaced discs here and there, each with its own range of depths; nothing elsewhere.
DistortionMap patchyMap(DistortionMap::Lookup lookup, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&](float least, float most) {
    return least + (most - least) * static_cast<float>(random() >> 8) / static_cast<float>(1 << 24);
  };
  DistortionMap map(test::kWidth, test::kHeight, lookup);
  for (int disc = 0; disc < 5; ++disc) {
    const glm::vec2 centre(next(0, 90), next(0, 60));
    const float inverseNear = 1 / next(8, 9.5f);
    const DistortionSample sample{{next(-9, 9), next(-9, 9)}, inverseNear, inverseNear * next(0.7f, 1.01f)};
    for (int y = 0; y < test::kHeight; ++y) {
      for (int x = 0; x < test::kWidth; ++x) {
        if (glm::distance(glm::vec2(x, y), centre) < 7) {
          map.samples()(x, y) = sample;
        }
      }
    }
  }
  return map;
}

TEST(DisplacementBounds, holdEveryDisplacementOfTheMap) {
  for (const auto lookup : {DistortionMap::Lookup::kNearest, DistortionMap::Lookup::kBilinear}) {
    const DistortionMap map = patchyMap(lookup, 5);
    const DisplacementBounds bounds(map);
    std::mt19937 random(7);
    const auto next = [&](float least, float most) {
      return least + (most - least) * static_cast<float>(random() >> 8) / static_cast<float>(1 << 24);
    };
    for (int round = 0; round < 2000; ++round) {
      const float side = round % 2 ? 3.0f : 50.0f;
      const glm::vec2 lower(next(-20, 95), next(-20, 65));
      const ImageBox box{lower, lower + glm::vec2(next(0, side), next(0, side))};
      const float zLeast = next(7, 13);
      const float zMost = zLeast + next(0, 2);
      const ImageBox bound = bounds.over(box).at(1 / zMost, 1 / zLeast);
      for (int i = 0; i < 20; ++i) {
        const glm::vec2 p(next(box.lower.x, box.upper.x), next(box.lower.y, box.upper.y));
        const glm::vec2 d = map.at(p.x, p.y).at(1 / next(zLeast, zMost));
        // Rounding of the four weights.
        ASSERT_TRUE(d.x >= bound.lower.x - 1e-4f && d.y >= bound.lower.y - 1e-4f) << p.x << " " << p.y;
        ASSERT_TRUE(d.x <= bound.upper.x + 1e-4f && d.y <= bound.upper.y + 1e-4f) << p.x << " " << p.y;
      }
    }
  }
}

// One disc of radius 6 around (40, 30), pushed by (8, 0) between 8 and 12.
TEST(DisplacementBounds, areTightAwayFromAnyDistortionAndWithinIt) {
  DistortionMap map(test::kWidth, test::kHeight, DistortionMap::Lookup::kBilinear);
  for (int y = 0; y < test::kHeight; ++y) {
    for (int x = 0; x < test::kWidth; ++x) {
      map.samples()(x, y) = {{glm::distance(glm::vec2(x, y), glm::vec2(40, 30)) < 6 ? 8 : 0, 0}, 1 / 8.0f, 1 / 12.0f};
    }
  }
  const DisplacementBounds bounds(map);
  // The finest cells are 4 pixels: 12 pixels from the centre nothing is left.
  const ImageBox none = bounds.over({{56, 30}, {57, 31}}).at(0.001f, 1);
  EXPECT_EQ(none.lower, glm::vec2(0));
  EXPECT_EQ(none.upper, glm::vec2(0));
  const ImageBox half = bounds.over({{40, 30}, {41, 31}}).at(1 / 9.6f, 1 / 9.6f);
  EXPECT_NEAR(half.upper.x, 4, 1e-5f) << "half of the ramp";
  const ImageBox before = bounds.over({{40, 30}, {41, 31}}).at(1 / 7.9f, 1);
  EXPECT_EQ(before.upper, glm::vec2(0));
  EXPECT_EQ(bounds.over({{-50, -50}, {200, 200}}).displacement.upper.x, 8);
}

}  // namespace
}  // namespace ocelli
