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
  EXPECT_TRUE(RayPath().empty());
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
