#include "oc_core/multiperspective/plan_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "oc_core/worlds/solids.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

/// Total length of the lines.
float lengthOf(const std::vector<SectionLine>& lines) {
  float length = 0;
  for (const SectionLine& line : lines) {
    length += glm::distance(line[0], line[1]);
  }
  return length;
}

TEST(PlanSection, paperOfEachSide) {
  const glm::vec3 p(1, 2, 3);
  EXPECT_EQ(onPaper(PlanSide::kTop, p), glm::vec2(1, 3));
  EXPECT_EQ(onPaper(PlanSide::kFront, p), glm::vec2(1, -2));
  EXPECT_EQ(onPaper(PlanSide::kRight, p), glm::vec2(-3, -2));
}

// The wall z = 2 with a half side of 3 is a line of length 6 from above and from the side, and not cut from the front.
TEST(PlanSection, wallIsALine) {
  const Mesh wall = test::wall(2, 3);
  const std::vector<SectionLine> top = sectionOf(wall, PlanSide::kTop, 0.1f);
  EXPECT_NEAR(lengthOf(top), 6, 1e-5);
  for (const SectionLine& line : top) {
    EXPECT_EQ(line[0].y, 2);
    EXPECT_EQ(line[1].y, 2);
  }
  EXPECT_NEAR(lengthOf(sectionOf(wall, PlanSide::kRight, 0.1f)), 6, 1e-5);
  EXPECT_TRUE(sectionOf(wall, PlanSide::kFront, 0).empty());
  EXPECT_TRUE(sectionOf(wall, PlanSide::kFront, 2).empty()) << "in the plane";
  EXPECT_TRUE(sectionOf(wall, PlanSide::kTop, 4).empty()) << "above it";
}

// Corners of triangles in the plane: each line is there once.
TEST(PlanSection, cutsThroughCornersAreWhole) {
  Mesh fan{{{-1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, -1, 0}}, {}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_NEAR(lengthOf(sectionOf(fan, PlanSide::kTop, 0)), 2, 1e-6);
}

TEST(PlanSection, brokenTrianglesGiveNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Mesh broken{{{-1, -1, 0}, {0, 1, nan}, {1, -1, 0}}, {}, {{0, 1, 2}, {0, 0, 0}}};
  EXPECT_TRUE(sectionOf(broken, PlanSide::kTop, 0).empty());
  EXPECT_TRUE(sectionOf(Mesh{}, PlanSide::kTop, 0).empty());
}

}  // namespace
}  // namespace ocelli
