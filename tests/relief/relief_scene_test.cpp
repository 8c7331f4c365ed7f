#include "oc_core/relief/relief_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/error.h"
#include "tests/relief/small_reliefs.h"

namespace ocelli {
namespace {

std::shared_ptr<const ReliefObject> boxObject() {
  return buildReliefObject("cell", test::redBox(), 4000).object;
}

TEST(ReliefScene, theNearestTileWins) {
  const ReliefScene scene({boxObject()}, {{0, placedAt({0, 0, -3}), glm::vec3(1)},
                                          {0, placedAt({0, 0, 0}), {0.5f, 1, 1}},
                                          {0, placedAt({4, 0, 0}), glm::vec3(1)}});
  RayCost cost;
  const StraightRay ray{{0, 0, 5}, {0, 0, -1}, 100};
  const auto found = scene.meet(ray, cost);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->tile, 1u);
  EXPECT_NEAR(found->meeting.share, 4.5, 0.02);
  const ReliefScene::Surface surface = scene.surfaceAt(*found, ray.step);
  EXPECT_NEAR(surface.color.x, 0.4f, 1e-2f);  // with the tint
  EXPECT_GT(surface.normal.z, 0.99f);
  EXPECT_TRUE(scene.meetsAny(ray, cost));
  EXPECT_FALSE(scene.meetsAny({{0, 0, 5}, {0, 0, 1}, 100}, cost));
  EXPECT_FALSE(scene.meet({{0, 0, 5}, {0, 0, -1}, 4}, cost));  // out of reach
}

// Shares are those of the world's ray, whatever the tile's scale, and normals stand across surfaces that are stretched.
TEST(ReliefScene, tilesAreScaledTurnedAndMirrored) {
  glm::mat4 stretched = glm::scale(placedAt({1, 2, 0}, 90), glm::vec3(-2, 1, 4));
  const ReliefScene scene({boxObject()}, {{0, stretched, glm::vec3(1)}});
  RayCost cost;
  // The tile's z, half side 0.5 times 4, runs along the world's x after the turn.
  const auto found = scene.meet({{10, 2, 0}, {-1, 0, 0}, 100}, cost);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->meeting.share, 10 - 1 - 2, 0.1);
  EXPECT_GT(scene.surfaceAt(*found, {-1, 0, 0}).normal.x, 0.99f);
  EXPECT_NEAR(scene.scaleOf(0), 2, 1e-5);
}

TEST(ReliefScene, theTreeFindsWhatLookingAtEveryTileFinds) {
  Random random(5);
  std::vector<ReliefTile> tiles;
  for (int i = 0; i < 30; ++i) {
    tiles.push_back({0,
                     glm::scale(placedAt({random.inRange(-3, 3), random.inRange(-3, 3), random.inRange(-3, 3)},
                                         static_cast<double>(random.inRange(0, 360)), {0.6f, 0.8f, 0}),
                                glm::vec3(random.inRange(0.3f, 1.2f))),
                     glm::vec3(1)});
  }
  const ReliefScene scene({buildReliefObject("di", test::table(), 500).object}, tiles);
  size_t met = 0;
  for (int i = 0; i < 1500; ++i) {
    const StraightRay ray = test::rayInto(random);
    RayCost cost;
    const auto fast = scene.meet(ray, cost);
    const auto slow = scene.meetSlowly(ray);
    ASSERT_EQ(fast.has_value(), slow.has_value());
    EXPECT_EQ(scene.meetsAny(ray, cost), slow.has_value());
    if (fast) {
      ++met;
      EXPECT_EQ(fast->tile, slow->tile);
      EXPECT_EQ(fast->meeting.share, slow->meeting.share);
    }
  }
  EXPECT_GT(met, 300u);
}

TEST(ReliefScene, emptyAndDegenerateTiles) {
  RayCost cost;
  const StraightRay ray{{0, 0, 5}, {0, 0, -1}, 100};
  EXPECT_FALSE(ReliefScene({}, {}).meet(ray, cost));
  EXPECT_TRUE(ReliefScene({}, {}).bounds().empty());
  const auto nothing = buildReliefObject("cell", Mesh{}, 4000).object;
  EXPECT_FALSE(ReliefScene({nothing}, {{0, glm::mat4(1), glm::vec3(1)}}).meet(ray, cost));
  const auto placed = [](const glm::mat4& place) { ReliefScene({boxObject()}, {{0, place, glm::vec3(1)}}); };
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  EXPECT_THAT(
      [&] {
        placed(glm::scale(glm::mat4(1), {1, 0, 1}));
      },
      ThrowsMessage<InputError>(HasSubstr("tile 1 is placed without an extent")));
  EXPECT_THROW(placed(placedAt({std::numeric_limits<float>::quiet_NaN(), 0, 0})), InputError);
}

// From inside of a box all around is its surface.
TEST(ReliefScene, raysBeginInsideOfATile) {
  const ReliefScene scene({buildReliefObject("cell", test::redBox(), 20'000).object},
                          {{0, glm::mat4(1), glm::vec3(1)}});
  RayCost cost;
  const auto found = scene.meet({{0, 0, 0}, {1, 0, 0}, 100}, cost);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->meeting.share, 0.5, 0.02);
}

}  // namespace
}  // namespace ocelli
