#include "oc_core/constructor/object_boxes.h"

#include <gtest/gtest.h>

#include "oc_core/base/random.h"

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

TEST(ObjectBoxes, segmentsMeetWhatTheyPass) {
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  EXPECT_TRUE(meets(box, {-3, 0, 0}, {3, 0, 0}));
  EXPECT_TRUE(meets(box, {0, 0, 0}, {0.1f, 0, 0}));  // within
  EXPECT_FALSE(meets(box, {-3, 0, 0}, {-2, 0, 0}));  // ends before it
  EXPECT_FALSE(meets(box, {-3, 1.5f, 0}, {3, 1.5f, 0}));
  EXPECT_FALSE(meets(box, {-3, 0, 0}, {0, 3, 0}));  // past the edge
  EXPECT_TRUE(contains(box, {1, 1, -1}));
  EXPECT_FALSE(contains(box, {1, 1.1f, 0}));
}

TEST(ObjectBoxes, segmentsMeetAsTheirPointsDo) {
  Random random(6);
  const Box box{{-0.5f, -0.3f, -0.4f}, {0.2f, 0.4f, 0.6f}};
  size_t met = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto point = [&] {
      const float x = random.inRange(-1, 1);
      const float y = random.inRange(-1, 1);
      return glm::vec3(x, y, random.inRange(-1, 1));
    };
    const glm::vec3 from = point();
    const glm::vec3 to = point();
    bool passes = false;
    for (int k = 0; k <= 400 && !passes; ++k) {
      passes = contains(box, from + (to - from) * (static_cast<float>(k) / 400));
    }
    met += passes;
    if (passes) {
      EXPECT_TRUE(meets(box, from, to));
    } else if (meets(box, from, to)) {
      // Between two of the points: only near the surface.
      const Box smaller{box.lower + 0.01f, box.upper - 0.01f};
      EXPECT_FALSE(meets(smaller, from, to));
    }
  }
  EXPECT_GT(met, 300u);
}

}  // namespace
}  // namespace ocelli
