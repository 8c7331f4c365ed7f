#include "oc_core/relief/height_field_relief.h"

#include <gtest/gtest.h>

#include "tests/relief/small_reliefs.h"

namespace ocelli {
namespace {

using test::placeOn;
using test::rayBetween;

HeightFieldRelief reliefOf(const Mesh& mesh, int layers, int size = 64, const ReliefSearch& search = {}) {
  return HeightFieldRelief(orthographicLayers(SurfaceLabels(mesh), size, size, layers), search);
}

// From above: the interval of a linear step is 1/16 of the way through the box, which has height 0.5; five halvings
// leave 1/512 of the way.
TEST(HeightFieldRelief, meetsTheTopOfABox) {
  const HeightFieldRelief relief = reliefOf(test::redBox(), 1);
  RayCost cost;
  const StraightRay ray = rayBetween({0.1f, 2, 0.1f}, {0.1f, 0, 0.1f});
  const auto found = relief.meet(ray, cost);
  ASSERT_TRUE(found);
  EXPECT_NEAR(placeOn(ray, *found).y, 0.25f, 0.5f / 512);
  EXPECT_NEAR(relief.surfaceAt(*found).color.x, 0.8f, 1e-5f);
  EXPECT_GT(glm::normalize(relief.surfaceAt(*found).normal).y, 0.999f);
}

TEST(HeightFieldRelief, passesBesideTheObject) {
  Mesh mesh = test::redBox({0.1f, 0.25f, 0.1f});
  // A sliver makes the box of the object larger than the column.
  append(mesh, test::redBox({0.01f, 0.01f, 0.5f}), placedAt({0.49f, -0.24f, 0}));
  const HeightFieldRelief relief = reliefOf(mesh, 1);
  RayCost cost;
  EXPECT_FALSE(relief.meet(rayBetween({0.3f, 2, 0.3f}, {0.3f, 0, 0.3f}), cost));
  EXPECT_TRUE(relief.meet(rayBetween({0, 2, 0}, {0, 0, 0}), cost));
  EXPECT_FALSE(relief.meet(rayBetween({5, 2, 5}, {5, 0, 5}), cost));
}

// What stands out above fills all below it: the rubber band of a height field. Two layers know of the gap.
TEST(HeightFieldRelief, fillsWhatHangsOverAndLayersDoNot) {
  const StraightRay below = rayBetween({-2, 0, 0.3f}, {0, 0, 0.3f});
  RayCost cost;
  const HeightFieldRelief field = reliefOf(test::table(), 1);
  const auto wall = field.meet(below, cost);
  ASSERT_TRUE(wall);
  EXPECT_NEAR(placeOn(below, *wall).x, -0.5f, 0.02f);
  const HeightFieldRelief layered = reliefOf(test::table(), 4);
  EXPECT_FALSE(layered.meet(below, cost));
  const StraightRay atLeg = rayBetween({-2, 0, 0}, {0, 0, 0});
  const auto leg = layered.meet(atLeg, cost);
  ASSERT_TRUE(leg);
  EXPECT_NEAR(placeOn(atLeg, *leg).x, -0.1f, 1.0f / 64 + 1.0f / 512);
  EXPECT_EQ(field.texels(), 64u * 64);
  EXPECT_EQ(layered.texels(), 4u * 64 * 64);
}

// 16 steps through a box of length 2 are 1/8 long: a plate of 1/25 stands between two of them.
TEST(HeightFieldRelief, stepsPassThinThings) {
  Mesh mesh = test::redBox({1, 0.01f, 0.5f});
  append(mesh, test::redBox({0.02f, 0.25f, 0.5f}), placedAt({0.0625f, 0.25f, 0}));
  const StraightRay ray = rayBetween({-3, 0.2f, 0}, {0, 0.2f, 0});
  RayCost cost;
  EXPECT_FALSE(reliefOf(mesh, 1, 256).meet(ray, cost));
  const HeightFieldRelief fine = reliefOf(mesh, 1, 256, {.linearSteps = 256});
  const auto found = fine.meet(ray, cost);
  ASSERT_TRUE(found);
  EXPECT_NEAR(placeOn(ray, *found).x, 0.0425f, 2.0f / 256);
  EXPECT_TRUE(reliefOf(mesh, 1, 256).meetSlowly(ray));
}

TEST(HeightFieldRelief, countsItsSteps) {
  const HeightFieldRelief relief = reliefOf(test::redBox(), 1);
  RayCost hit;
  relief.meet(rayBetween({0.1f, 2, 0.1f}, {0.1f, 0, 0.1f}), hit);
  EXPECT_EQ(hit.cells, 0u);  // inside at the entry
  EXPECT_EQ(hit.nodes, 1u);
  RayCost slanted;
  const Mesh steps = test::table();
  reliefOf(steps, 4).meet(rayBetween({-2, 0, 0}, {0, 0, 0}), slanted);
  EXPECT_LE(slanted.nodes, 17u);
  EXPECT_EQ(slanted.cells, 5u);
}

TEST(HeightFieldRelief, takesWhatHasNoThicknessAndWhatIsEmpty) {
  Mesh flat;
  flat.positions = {{-0.5f, 0.1f, -0.5f}, {0.5f, 0.1f, -0.5f}, {0.5f, 0.1f, 0.5f}, {-0.5f, 0.1f, 0.5f}};
  flat.triangles = {{0, 2, 1}, {0, 3, 2}};
  RayCost cost;
  const StraightRay ray = rayBetween({0.1f, 2, 0.1f}, {0.1f, 0, 0.1f});
  const HeightFieldRelief one = reliefOf(flat, 1);
  const auto found = one.meet(ray, cost);
  ASSERT_TRUE(found);
  EXPECT_NEAR(placeOn(ray, *found).y, 0.1f, 1e-5f);
  const HeightFieldRelief empty = reliefOf(Mesh{}, 2);
  EXPECT_FALSE(empty.meet(ray, cost));
  EXPECT_TRUE(empty.bounds().empty());
  EXPECT_TRUE(reliefOf(test::redBox(), 1, 1).meet(ray, cost));  // an image of one pixel
}

}  // namespace
}  // namespace ocelli
