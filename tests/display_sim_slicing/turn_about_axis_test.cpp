#include "display_sim/slicing/turn_about_axis.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

// Seen from above (+y), with x to the right, z points down: a quarter counter-clockwise takes x to -z.
TEST(TurnAboutAxis, aQuarterTakesRightToTheBack) {
  EXPECT_LT(glm::distance(turnedAboutAxis({1, 0.5f, 0}, kPi / 2), glm::vec3(0, 0.5f, -1)), 1e-7f);
  EXPECT_LT(glm::distance(turnedAboutAxis({0, 0.5f, -1}, kPi / 2), glm::vec3(-1, 0.5f, 0)), 1e-7f);
}

TEST(TurnAboutAxis, noneLeavesAllAsItIs) {
  EXPECT_EQ(turnedAboutAxis({0.3f, -0.7f, 0.2f}, 0), glm::vec3(0.3f, -0.7f, 0.2f));
}

TEST(TurnAboutAxis, manyAreTurnedAsEachIsAndInPlace) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 40000; ++i) {  // more than a thread takes at once
    points.emplace_back(static_cast<float>(i) * 1e-4f, static_cast<float>(i % 7), static_cast<float>(i % 11));
  }
  std::vector<glm::vec3> turned(points.size());
  turnAboutAxis(points, 0.7, turned);
  for (size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(turned[i], turnedAboutAxis(points[i], 0.7)) << i;
  }
  turnAboutAxis(points, 0.7, points);
  EXPECT_EQ(points, turned);
}

}  // namespace
}  // namespace ocelli
