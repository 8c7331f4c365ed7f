#include "oc_core/constructor/object_boxes.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(ObjectBoxes, holdTheTrianglesOfEachIdentity) {
  GuidedScene scene;
  scene.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {5, 5, 5}, {6, 5, 4}, {5, 7, 5}};
  scene.mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  scene.objectOfTriangle = {0, 2};
  const std::vector<Box> boxes = objectBoxes(scene);
  ASSERT_EQ(boxes.size(), 3u);
  EXPECT_EQ(boxes[0].upper, glm::vec3(1, 2, 0));
  EXPECT_TRUE(boxes[1].empty());
  EXPECT_EQ(boxes[2].lower, glm::vec3(5, 5, 4));
  EXPECT_EQ(boxes[2].upper, glm::vec3(6, 7, 5));
  EXPECT_TRUE(objectBoxes({}).empty());
}

}  // namespace
}  // namespace ocelli
