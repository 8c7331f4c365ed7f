#include "oc_core/worlds/blocks_on_floor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

TEST(BlocksOnFloor, StandApart) {
  for (const size_t count : {1u, 2u, 50u, 700u}) {
    const Scene scene = makeBlocksOnFloor(count, 3);
    ASSERT_EQ(scene.instances.size(), count + 1);
    EXPECT_EQ(scene.instances[0].object, 0u);
    const auto center = [&](size_t i) { return glm::vec3(scene.instances[i].worldFromMesh[3]); };
    const auto reach = [&](size_t i) {
      const glm::mat3 m(scene.instances[i].worldFromMesh);
      return std::hypot(glm::length(m[0]), glm::length(m[2]));
    };
    const float floor = boundsOf(scene.meshes[0]).upper.y;
    for (size_t i = 1; i <= count; ++i) {
      EXPECT_EQ(scene.instances[i].object, i);
      EXPECT_NEAR(center(i).y - scene.instances[i].worldFromMesh[1].y, floor, 1e-6f) << "it stands on the floor";
      EXPECT_LE(std::abs(center(i).x) + reach(i), boundsOf(scene.meshes[0]).upper.x);
      for (size_t j = 1; j < i; ++j) {
        EXPECT_GT(std::hypot(center(i).x - center(j).x, center(i).z - center(j).z), reach(i) + reach(j));
      }
    }
  }
}

TEST(BlocksOnFloor, KnowTheirTarget) {
  const GuidedScene scene = loadGuidedScene("builtin:boxes,count=700,floor=1", {.shading = Shading::kNone});
  ASSERT_TRUE(scene.guides.target);
  Box box;
  size_t red = 0;
  for (size_t i = 0; i < scene.mesh.triangles.size(); ++i) {
    const bool isTarget = scene.objectOfTriangle[i] == scene.guides.target->object;
    const glm::vec3 color = scene.mesh.color(scene.mesh.triangles[i].x);
    const bool isRed = color.x > 5 * color.y && color.x > 5 * color.z;
    EXPECT_EQ(isRed, isTarget);
    red += isRed ? 1 : 0;
    for (glm::length_t corner = 0; isTarget && corner < 3; ++corner) {
      box.add(scene.mesh.positions[scene.mesh.triangles[i][corner]]);
    }
  }
  EXPECT_EQ(red, 12u);
  EXPECT_LT(glm::distance(box.lower, scene.guides.target->box.lower), 1e-6f);
  EXPECT_LT(glm::distance(box.upper, scene.guides.target->box.upper), 1e-6f);
  EXPECT_LT(glm::length(scene.guides.target->box.center()), 0.15f) << "near the middle";
}

TEST(BlocksOnFloor, FollowTheSeed) {
  EXPECT_EQ(flatten(makeBlocksOnFloor(99, 1)).positions, flatten(makeBlocksOnFloor(99, 1)).positions);
  EXPECT_NE(flatten(makeBlocksOnFloor(99, 1)).positions, flatten(makeBlocksOnFloor(99, 2)).positions);
}

}  // namespace
}  // namespace ocelli
