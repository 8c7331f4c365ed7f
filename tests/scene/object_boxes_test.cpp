#include "oc_core/scene/object_boxes.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(ObjectBoxes, HoldTheTrianglesOfEachObject) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {6, 5, 4}, {5, 7, 5}, {-3, 0, 0}, {99, 99, 99}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {0, 1, 6}};
  const std::map<uint32_t, Box> boxes = boxesOfObjects(mesh, {2, 0, 2});
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(boxes.at(0).lower, glm::vec3(5, 5, 4));
  EXPECT_EQ(boxes.at(0).upper, glm::vec3(6, 7, 5));
  EXPECT_EQ(boxes.at(2).lower, glm::vec3(-3, 0, 0));
  EXPECT_EQ(boxes.at(2).upper, glm::vec3(1, 1, 0));
  EXPECT_TRUE(boxesOfObjects({}, {}).empty());
}

}  // namespace
}  // namespace ocelli
