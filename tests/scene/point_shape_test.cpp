#include "oc_core/scene/point_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "oc_core/base/random.h"
#include "oc_core/scene/point_orientation.h"

namespace ocelli {
namespace {

glm::vec3 randomUnit(Random& random) {
  glm::vec3 v(0);
  while (glm::length(v) < 0.1f || glm::length(v) > 1) {
    v = {random.inRange(-1, 1), random.inRange(-1, 1), random.inRange(-1, 1)};
  }
  return glm::normalize(v);
}

TEST(FittingPlane, FindsTheNormalOfPointsInAPlane) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const glm::vec3 normal = randomUnit(random);
    const glm::vec3 x = glm::normalize(glm::cross(normal, randomUnit(random)));
    const glm::vec3 y = glm::cross(normal, x);
    std::vector<glm::vec3> offsets;
    for (int i = 0; i < 10; ++i) {
      offsets.push_back(1e-3f * (random.inRange(-1, 1) * x + random.inRange(-1, 1) * y));
    }
    const PointPlane plane = fittingPlane(offsets);
    EXPECT_TRUE(plane.isSurface);
    EXPECT_NEAR(std::abs(glm::dot(plane.normal, normal)), 1, 1e-5f);  // of floats: cosines are right to their square
  }
}

TEST(FittingPlane, KnowsWhatIsNoSurface) {
  std::vector<glm::vec3> line;
  std::vector<glm::vec3> space;
  std::vector<glm::vec3> edge;  // of two planes at a right angle, along z
  for (int i = 1; i <= 5; ++i) {
    const auto step = static_cast<float>(i);
    line.insert(line.end(), {{step, 2 * step, 0}, {-step, -2 * step, 0}});
  }
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 offset(0);
      offset[axis] = side;
      space.push_back(offset);
    }
  }
  for (const float z : {-1.0f, 0.0f, 1.0f}) {
    for (const float along : {0.25f, 0.5f, 0.75f, 1.0f}) {
      edge.push_back({along, 0, z});
      edge.push_back({0, along, z});
    }
  }
  EXPECT_FALSE(fittingPlane(line).isSurface);
  EXPECT_FALSE(fittingPlane(space).isSurface);
  EXPECT_FALSE(fittingPlane(std::vector<glm::vec3>{{1, 0, 0}}).isSurface);
  EXPECT_TRUE(fittingPlane(edge).isSurface);
  EXPECT_NEAR(std::abs(glm::dot(fittingPlane(edge).normal, glm::normalize(glm::vec3(1, 1, 0)))), 1, 1e-5f);
}

TEST(CellPanel, IsTheCellOfASquareGrid) {
  std::vector<glm::vec3> offsets;
  for (const float x : {-2.0f, 0.0f, 2.0f}) {
    for (const float y : {-1.0f, 0.0f, 1.0f}) {
      if (x != 0 || y != 0) {
        offsets.push_back({x, y, 0});
      }
    }
  }
  const PointPanel panel = cellPanel(offsets, {0, 0, 1}, 10);
  EXPECT_NEAR(glm::length(panel.center), 0, 1e-6f);
  EXPECT_NEAR(std::abs(panel.halfX.x), 1, 1e-6f) << "along the wider spread";
  EXPECT_NEAR(std::abs(panel.halfY.y), 0.5f, 1e-6f);
  EXPECT_GT(glm::cross(panel.halfX, panel.halfY).z, 0);
}

TEST(CellPanel, EndsAtTheReachWhereNoNeighborIs) {
  // All neighbours are on one side.
  const std::vector<glm::vec3> offsets{{1, 0, 0}, {1, 1, 0}, {1, -1, 0}, {2, 0, 0}};
  const PointPanel panel = cellPanel(offsets, {0, 0, -1}, 3);
  const glm::vec3 half = glm::abs(panel.halfX) + glm::abs(panel.halfY);
  EXPECT_NEAR(panel.center.x + half.x, 0.5f, 1e-5f);
  EXPECT_NEAR(panel.center.x - half.x, -3, 1e-5f);
}

TEST(CellPanel, IgnoresOtherSurfaces) {
  const std::vector<glm::vec3> sheet{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  std::vector<glm::vec3> both = sheet;
  both.push_back({0.1f, 0.1f, -0.3f});  // below
  const PointPanel one = cellPanel(sheet, {0, 0, 1}, 2);
  const PointPanel two = cellPanel(both, {0, 0, 1}, 2);
  // The corners of the cell of a cross are at 0.5; the axes of the spread may be turned by the one below.
  EXPECT_NEAR(glm::length(one.halfX), 0.5f, 1e-5f);
  EXPECT_GE(glm::length(two.halfX), 0.5f - 1e-5f);
  EXPECT_GE(glm::length(two.halfY), 0.5f - 1e-5f);
}

TEST(CellPanel, TakesNeighborsAsNearAsRounding) {
  Random random(14);
  for (int round = 0; round < 20'000; ++round) {
    const glm::vec3 normal = randomUnit(random);
    std::vector<glm::vec3> offsets;
    for (size_t i = 0; i < kMaxPanelNeighbors; ++i) {
      // Some far ones, and groups that are apart by about the rounding of these.
      offsets.push_back(i % 4 == 0 ? 0.1f * randomUnit(random) : offsets.back() + 1e-7f * randomUnit(random));
    }
    const PointPanel panel = cellPanel(offsets, normal, 1);
    const float halves = glm::length(panel.halfX) + glm::length(panel.halfY);
    ASSERT_GT(halves, 0) << round;
    ASSERT_LE(glm::length(panel.center) + halves, 3 * std::sqrt(2.0f)) << round;
  }
}

/// The neighbours of points on a ring of `count`, in the plane z = 0: the two beside each.
std::vector<uint32_t> ringLinks(uint32_t count) {
  std::vector<uint32_t> links;
  for (uint32_t i = 0; i < count; ++i) {
    links.insert(links.end(), {(i + 1) % count, (i + count - 1) % count});
  }
  return links;
}

TEST(OrientNormals, TurnsThoseOfARingOutwards) {
  Random random(4);
  constexpr uint32_t kCount = 60;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  for (uint32_t i = 0; i < kCount; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / kCount;
    positions.push_back({std::cos(angle), std::sin(angle), 0});
    normals.push_back(positions.back() * (random.below(2) == 0 ? 1.0f : -1.0f));
  }
  orientNormals(positions, ringLinks(kCount), 2, normals);
  for (uint32_t i = 0; i < kCount; ++i) {
    EXPECT_GT(glm::dot(normals[i], positions[i]), 0.99f);
  }
}

TEST(OrientNormals, GivesTheSidesOfAThinSheetOppositeOnes) {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<uint32_t> links;
  for (uint32_t i = 0; i < 10; ++i) {
    for (const float y : {0.0f, 0.3f}) {
      positions.push_back({static_cast<float>(i), y, 0});
      normals.push_back({0, 1, 0});
    }
    // To the point across, and to the next one of the same side, which does not name it.
    links.insert(links.end(), {2 * i + 1, i < 9 ? 2 * i + 2 : kNoNeighbor});
    links.insert(links.end(), {2 * i, i < 9 ? 2 * i + 3 : kNoNeighbor});
  }
  orientNormals(positions, links, 2, normals);
  for (uint32_t i = 0; i < 20; ++i) {
    EXPECT_EQ(normals[i].y, i % 2 == 0 ? -1 : 1) << i;
  }
}

TEST(OrientNormals, JoinsPartsThatNameEachOtherInOneDirection) {
  // Two rows beside each other in one plane; the second one names the first, and comes after it.
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<uint32_t> links;
  for (uint32_t row = 0; row < 2; ++row) {
    for (uint32_t i = 0; i < 8; ++i) {
      positions.push_back({static_cast<float>(i), static_cast<float>(row), 0});
      normals.push_back({0, 0, row == 0 ? 1 : -1});
      links.push_back(row * 8 + (i + 1) % 8);
      links.push_back(row == 1 ? i : kNoNeighbor);
    }
  }
  orientNormals(positions, links, 2, normals);
  for (const glm::vec3& normal : normals) {
    EXPECT_EQ(normal.z, 1) << "a flat part looks towards +z";
  }
}

TEST(OrientNormals, JoinsVeryManyPartsInARow) {
  // Each point names the one before it in the row alone, so that it is a part of its own. Normals turn less and less
  // along the row, so that parts are joined from its end on, each to all behind it; and the second point is at the end.
  constexpr uint32_t kCount = 500'000;
  const auto pointAt = [](uint32_t place) { return place == 0 ? 0 : place == kCount - 1 ? 1 : place + 1; };
  Random random(11);
  std::vector<glm::vec3> positions(kCount);
  std::vector<glm::vec3> even(kCount);
  std::vector<glm::vec3> normals(kCount);
  std::vector<uint32_t> links(2 * kCount, kNoNeighbor);
  double angle = 0;
  for (uint32_t place = 0; place < kCount; ++place) {
    const uint32_t point = pointAt(place);
    positions[point] = {static_cast<float>(place), 0, 0};
    even[point] = glm::vec3(0, std::cos(angle), std::sin(angle));
    normals[point] = even[point] * (random.below(2) == 0 ? 1.0f : -1.0f);
    if (point > 1) {
      links[2 * point] = pointAt(place - 1);
    }
    angle += 1 - 0.95 * place / kCount;
  }
  links[2 * (kCount - 1) + 1] = 1;  // named by its only neighbour, as it comes before that
  orientNormals(positions, links, 2, normals);
  const float side = glm::dot(normals[0], even[0]);
  for (uint32_t i = 0; i < kCount; ++i) {
    ASSERT_NEAR(glm::dot(normals[i], even[i]), side, 1e-6f) << i;
  }
}

TEST(OrientNormals, TakesPointsAtOnePlace) {
  // The square of the second distance is less than what floats hold.
  for (const float apart : {0.0f, 1e-30f}) {
    const std::vector<glm::vec3> positions{{0, 0, 0}, {apart, 0, 0}};
    std::vector<glm::vec3> normals{{0, 0, 1}, {0, 0, -1}};
    orientNormals(positions, std::vector<uint32_t>{1, 0}, 1, normals);
    EXPECT_EQ(normals, std::vector<glm::vec3>(2, glm::vec3(0, 0, 1))) << apart;
  }
}

}  // namespace
}  // namespace ocelli
