#include "oc_core/labels/filled_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ocelli {
namespace {

using Outlines = std::vector<std::vector<glm::dvec2>>;

double areaOfTriangle(const FilledOutline& filled, const glm::uvec3& t) {
  const glm::dvec2 ab = filled.corners[t.y] - filled.corners[t.x];
  const glm::dvec2 ac = filled.corners[t.z] - filled.corners[t.x];
  return (ab.x * ac.y - ab.y * ac.x) / 2;
}

/// Each triangle must be counter-clockwise.
double filledArea(const FilledOutline& filled) {
  double sum = 0;
  for (const glm::uvec3& t : filled.triangles) {
    EXPECT_GT(areaOfTriangle(filled, t), 0);
    sum += areaOfTriangle(filled, t);
  }
  return sum;
}

std::vector<glm::dvec2> polygon(size_t corners, double radius, bool clockwise = false) {
  std::vector<glm::dvec2> places;
  for (size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners) + 0.1;
    places.emplace_back(radius * std::cos(angle), (clockwise ? -1 : 1) * radius * std::sin(angle));
  }
  return places;
}

double polygonArea(size_t corners, double radius) {
  const double angle = 2 * std::numbers::pi / static_cast<double>(corners);
  return static_cast<double>(corners) * radius * radius * std::sin(angle) / 2;
}

constexpr double kRounding = 1e-12;

TEST(FilledOutline, FillsWhatOneOutlineGoesAround) {
  for (const bool clockwise : {false, true}) {
    EXPECT_NEAR(filledArea(fillOutlines({polygon(17, 2, clockwise)})), polygonArea(17, 2), kRounding);
  }
  EXPECT_TRUE(fillOutlines({}).triangles.empty());
  EXPECT_TRUE(fillOutlines({{{0, 1}, {2, 1}, {1, 1}}}).triangles.empty()) << "a flat one";
}

// The ring of an "o": outlines of opposite directions.
TEST(FilledOutline, LeavesHolesOut) {
  const FilledOutline ring = fillOutlines({polygon(40, 2), polygon(30, 1, true)});
  EXPECT_NEAR(filledArea(ring), polygonArea(40, 2) - polygonArea(30, 1), kRounding);
  for (const glm::uvec3& t : ring.triangles) {
    const glm::dvec2 middle = (ring.corners[t.x] + ring.corners[t.y] + ring.corners[t.z]) / 3.0;
    EXPECT_GT(std::hypot(middle.x, middle.y), 0.9);
  }
}

// Letters of variable fonts are made of strokes that overlap.
TEST(FilledOutline, FillsOnceWhereOutlinesOfOneDirectionOverlap) {
  const Outlines cross{{{-3, -1}, {3, -1}, {3, 1}, {-3, 1}}, {{-1, -3}, {1, -3}, {1, 3}, {-1, 3}}};
  EXPECT_NEAR(filledArea(fillOutlines(cross)), 12 + 12 - 4, kRounding);
}

TEST(FilledOutline, MakesOneTrapezoidBetweenTheSameEdges) {
  // The notch on the left asks for heights that the right edge, and the left one below it, do not have.
  const FilledOutline one = fillOutlines({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  EXPECT_EQ(one.triangles.size(), 2u);
  const FilledOutline notched = fillOutlines({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 3}, {1, 2.5}, {0, 2}}});
  EXPECT_NEAR(filledArea(notched), 16 - 0.5, kRounding);
  EXPECT_EQ(notched.triangles.size(), 8u);
}

}  // namespace
}  // namespace ocelli
