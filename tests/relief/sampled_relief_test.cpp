#include "oc_core/relief/sampled_relief.h"

#include <gtest/gtest.h>

#include "tests/relief/small_reliefs.h"

namespace ocelli {
namespace {

TEST(SampledRelief, meetsWhatTestingEveryCellMeets) {
  for (const char* way : {"di", "spoc", "cell", "ldi-2"}) {
    const BuiltRelief built = buildReliefObject(way, test::table(), 2000);
    Random random(7);
    size_t met = 0;
    for (int i = 0; i < 2000; ++i) {
      const StraightRay ray = test::rayInto(random);
      RayCost cost;
      const auto fast = built.object->meet(ray, cost);
      const auto slow = built.object->meetSlowly(ray);
      ASSERT_EQ(fast.has_value(), slow.has_value()) << way;
      if (fast) {
        ++met;
        EXPECT_EQ(fast->share, slow->share) << way;
        EXPECT_EQ(fast->triangle, slow->triangle) << way;
      }
    }
    EXPECT_GT(met, 200u) << way;
  }
}

// Colours come from the mesh through labels, normals too.
TEST(SampledRelief, showsColoursAndNormalsOfTheMesh) {
  const BuiltRelief built = buildReliefObject("cell", test::table(), 20'000);
  RayCost cost;
  const auto top = built.object->meet(test::rayBetween({0.2f, 3, 0.1f}, {0.2f, 0, 0.1f}), cost);
  ASSERT_TRUE(top);
  EXPECT_NEAR(built.object->surfaceAt(*top).color.x, 0.8f, 1e-3f);
  EXPECT_GT(glm::normalize(built.object->surfaceAt(*top).normal).y, 0.99f);
  // The leg, under the plate, which no view from above sees.
  const StraightRay low = test::rayBetween({-3, -0.1f, 0.02f}, {0, -0.2f, 0.02f});
  const auto leg = built.object->meet(low, cost);
  ASSERT_TRUE(leg);
  EXPECT_NEAR(test::placeOn(low, *leg).x, -0.1f, 0.02f);
  EXPECT_NEAR(built.object->surfaceAt(*leg).color.z, 0.8f, 1e-2f);
  EXPECT_LT(glm::normalize(built.object->surfaceAt(*leg).normal).x, -0.9f);
}

}  // namespace
}  // namespace ocelli
