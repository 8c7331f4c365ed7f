#include "oc_core/render/half_spaces.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(HalfSpaces, sidesOfAPlane) {
  const Plane plane = Plane::through({0, 0, 2}, {0, 0, 1});
  const auto holds = [](const HalfSpace& space, double z) { return glm::dot(space, glm::dvec4(0, 0, z, 1)) >= 0; };
  EXPECT_TRUE(holds(beyond(plane), 2.1));
  EXPECT_FALSE(holds(beyond(plane), 1.9));
  EXPECT_TRUE(holds(beyond(plane, 0.2), 1.9));
  EXPECT_TRUE(holds(before(plane), 1.9));
  EXPECT_FALSE(holds(before(plane), 2.1));
  EXPECT_TRUE(holds(before(plane, 0.2), 2.1));
}

TEST(HalfSpaces, boxesInsideOutsideAndAcross) {
  const HalfSpaces spaces{beyond(Plane::through({0, 0, 0}, {1, 0, 0})), beyond(Plane::through({0, 0, 0}, {0, 1, 1}))};
  EXPECT_EQ(placementOf({{1, 1, 1}, {2, 2, 2}}, spaces), Placement::kInside);
  EXPECT_EQ(placementOf({{-1, 1, 1}, {2, 2, 2}}, spaces), Placement::kAcross);
  EXPECT_EQ(placementOf({{-2, 1, 1}, {-1, 2, 2}}, spaces), Placement::kOutside);
  EXPECT_EQ(placementOf({{1, -3, -3}, {2, -2, 1}}, spaces), Placement::kOutside);
}

// The unit triangle, cut at x = 1/4: corners and weights by hand.
TEST(Clipper, cutsATriangle) {
  Clipper clipper;
  const HalfSpaces right{beyond(Plane::through({0.25, 0, 0}, {1, 0, 0}))};
  const std::vector<ClipCorner> corners = clipper.clip({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, right);
  ASSERT_EQ(corners.size(), 3u);
  double area = 0;
  for (const ClipCorner& corner : corners) {
    EXPECT_GE(corner.p.x, 0.25);
    EXPECT_NEAR(corner.b.x, corner.p.x, 1e-15);  // its weights are its coordinates
    EXPECT_NEAR(corner.b.y, corner.p.y, 1e-15);
  }
  area = glm::length(glm::cross(corners[1].p - corners[0].p, corners[2].p - corners[0].p)) / 2;
  EXPECT_NEAR(area, 0.5 * 0.75 * 0.75, 1e-15);
  EXPECT_EQ(clipper.clip({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, HalfSpaces{}).size(), 3u);
  EXPECT_TRUE(clipper.clip({0, 0, 0}, {0.1f, 0, 0}, {0, 1, 0}, right).empty());
}

TEST(Clipper, sharedEdgesAreCutAlike) {
  Clipper clipper;
  const HalfSpaces spaces{beyond(Plane::through({0.3, 0.1, 0.2}, {0.3, -0.5, 0.7}))};
  const glm::vec3 a(-7.1f, 0.3f, -2);
  const glm::vec3 b(3.7f, 1.9f, 11);
  const auto cutOf = [&](const std::vector<ClipCorner>& corners) {
    std::vector<glm::dvec3> on;  // the edge: weights of the third vertex are 0
    for (const ClipCorner& corner : corners) {
      if (corner.b.y == 0 && corner.p != glm::dvec3(a) && corner.p != glm::dvec3(b)) {
        on.push_back(corner.p);
      }
    }
    return on;
  };
  const auto one = cutOf(clipper.clip(a, b, {0, 5, 0}, spaces));
  const auto other = cutOf(clipper.clip(b, a, {2, -9, 1}, spaces));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one, other);
}

}  // namespace
}  // namespace ocelli
