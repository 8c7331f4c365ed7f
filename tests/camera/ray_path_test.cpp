#include "oc_core/camera/ray_path.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(RayPath, holdsItsPointsInOrder) {
  RayPath path{{1, 2, 3}, {4, 5, 6}};
  path.push_back({7, 8, 9});
  ASSERT_EQ(path.size(), 3u);
  EXPECT_EQ(path.front(), glm::vec3(1, 2, 3));
  EXPECT_EQ(path[1], glm::vec3(4, 5, 6));
  EXPECT_EQ(path.back(), glm::vec3(7, 8, 9));
  const RayPath copy = path;
  EXPECT_TRUE(copy == path);
  path = {{1, 2, 3}};
  EXPECT_FALSE(copy == path);
  EXPECT_EQ(copy.size(), 3u);
  EXPECT_EQ(copy.tMax(), copy.t(2));
  EXPECT_TRUE(RayPath().empty());
}

TEST(RayPath, withoutParametersTIsTheLength) {
  const RayPath path{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}};
  EXPECT_EQ(path.t(0), 0);
  EXPECT_EQ(path.t(1), 3);
  EXPECT_EQ(path.tMax(), 7);
}

TEST(RayPath, parametersAreInterpolatedAlongItsSegments) {
  RayPath path;
  path.add({0, 0, 0}, 10);
  path.add({3, 0, 0}, 11);
  path.add({3, 4, 0}, 19);
  EXPECT_EQ(path.pointAt(path.positionAt(10.5f)), glm::vec3(1.5f, 0, 0));
  EXPECT_EQ(path.pointAt(path.positionAt(15)), glm::vec3(3, 2, 0));
  EXPECT_EQ(path.directionAt(path.positionAt(15)), glm::vec3(0, 1, 0));
  EXPECT_EQ(path.positionAt(11).segment, 1u) << "the segment that begins there";
  EXPECT_EQ(path.pointAt(path.positionAt(1)), glm::vec3(0, 0, 0)) << "before its begin";
  EXPECT_EQ(path.pointAt(path.positionAt(99)), glm::vec3(3, 4, 0)) << "beyond its end";
  for (const float t : {10.25f, 11.0f, 18.0f}) {
    EXPECT_EQ(path.tAt(path.positionAt(t)), t);
  }
}

TEST(RayPath, positionNearIsTheFootOfThePerpendicular) {
  const RayPath path{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}};
  EXPECT_EQ(path.tAt(path.positionNear({2, 0.1f, 0})), 2);
  EXPECT_EQ(path.tAt(path.positionNear({3.1f, 3, 0})), 6);
  EXPECT_EQ(path.tAt(path.positionNear({3, 9, 0})), 7) << "beyond the end";
  EXPECT_EQ(path.directionAt(path.positionNear({3, 9, 0})), glm::vec3(0, 1, 0));
}

TEST(RayPathDeathTest, refusesMoreThanItHolds) {
  RayPath path;
  for (size_t i = 0; i < RayPath::kMaxPoints; ++i) {
    path.push_back({0, 0, 0});
  }
  EXPECT_DEATH(path.push_back({0, 0, 0}), "too many points");
}

}  // namespace
}  // namespace ocelli
