#include "oc_core/scene/line_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Positive where the triangles turn outwards.
double volumeOf(const Mesh& mesh) {
  double six = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    six += glm::dot(glm::dvec3(mesh.positions[t.x]),
                    glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z])));
  }
  return six / 6;
}

/// Each edge is of two triangles that turn the same way round.
void expectClosed(const Mesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> uses;
  for (const glm::uvec3& t : mesh.triangles) {
    for (glm::length_t i = 0; i < 3; ++i) {
      ++uses[{t[i], t[(i + 1) % 3]}];
    }
  }
  for (const auto& [edge, count] : uses) {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(uses.count({edge.second, edge.first}), 1u);
  }
}

/// The area of eight sides around a circle of radius 1.
const double kOctagon = 2 * std::numbers::sqrt2;

TEST(MeshOfLines, MakesAClosedTube) {
  const Mesh mesh = meshOfLines({{{0, 0, 0}, {0, 0, 3}}, {}, {{0, 1}}}, 0.2, "test");
  expectClosed(mesh);
  EXPECT_EQ(mesh.triangles.size(), 32u);
  // A prism of length 3, and two cones as high as they are wide at half.
  EXPECT_NEAR(volumeOf(mesh), kOctagon * 0.01 * (3 + 2 * 0.1 / 3), 1e-6);
  for (const glm::vec3& p : mesh.positions) {
    EXPECT_LE(std::hypot(p.x, p.y), 0.1001f);
    EXPECT_TRUE(p.z >= -0.1001f && p.z <= 3.1001f);
  }
}

TEST(MeshOfLines, GoesOnWhereSegmentsMeet) {
  // The same line in three segments, of which one is given the other way round.
  const Mesh mesh =
      meshOfLines({{{0, 0, 0}, {0, 0, 1}, {0, 0, 2.5f}, {0, 0, 3}}, {}, {{1, 2}, {1, 0}, {2, 3}}}, 0.2, "test");
  expectClosed(mesh);
  EXPECT_EQ(mesh.positions.size(), 4 * 8 + 2u);
  EXPECT_NEAR(std::abs(volumeOf(mesh)), kOctagon * 0.01 * (3 + 2 * 0.1 / 3), 1e-6);
  EXPECT_GT(volumeOf(mesh), 0);
}

// Where a tube bends, its rings stand half-way between: as much is added outside as is missing inside.
TEST(MeshOfLines, IsMitredWhereItBends) {
  const float s = std::sqrt(0.5f);
  const Mesh mesh = meshOfLines({{{0, 0, 0}, {2, 0, 0}, {2 + 2 * s, 2 * s, 0}}, {}, {{0, 1}, {1, 2}}}, 0.2, "test");
  expectClosed(mesh);
  EXPECT_EQ(mesh.positions.size(), 3 * 8 + 2u);
  EXPECT_NEAR(volumeOf(mesh), kOctagon * 0.01 * (4 + 2 * 0.1 / 3), 1e-6);
  // Each vertex of the middle ring is as far from both lines.
  for (size_t i = 9; i < 17; ++i) {
    const glm::vec3 p = mesh.positions[i] - glm::vec3(2, 0, 0);
    EXPECT_NEAR(glm::length(glm::cross(p, glm::vec3(1, 0, 0))), 0.1f, 1e-5f);
    EXPECT_NEAR(glm::length(glm::cross(p, glm::vec3(s, s, 0))), 0.1f, 1e-5f);
  }
}

TEST(MeshOfLines, HasEndsAtForksAndSharpBends) {
  // A fork of three, and a bend by more than a right angle: as many tubes as segments.
  const Mesh fork =
      meshOfLines({{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, -1, 0}}, {}, {{0, 1}, {1, 2}, {1, 3}}}, 0.1, "test");
  EXPECT_EQ(fork.positions.size(), 3 * 18u);
  const Mesh sharp = meshOfLines({{{0, 0, 0}, {1, 0, 0}, {0, 0.2f, 0}}, {}, {{0, 1}, {1, 2}}}, 0.1, "test");
  EXPECT_EQ(sharp.positions.size(), 2 * 18u);
  expectClosed(fork);
  expectClosed(sharp);
}

TEST(MeshOfLines, GoesAroundLoopsOnce) {
  LineSet ring;
  constexpr uint32_t kCorners = 60;
  for (uint32_t i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    ring.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    ring.segments.emplace_back(i, (i + 1) % kCorners);
  }
  const Mesh mesh = meshOfLines(ring, 0.1, "test");
  expectClosed(mesh);
  EXPECT_EQ(mesh.positions.size(), (kCorners + 1) * 8 + 2u);
  const double length = kCorners * 2 * std::sin(std::numbers::pi / kCorners);
  EXPECT_NEAR(volumeOf(mesh), kOctagon * 0.0025 * (length + 2 * 0.05 / 3), 0.002 * volumeOf(mesh));
}

TEST(MeshOfLines, HasTheColorsOfItsVertices) {
  const Mesh mesh = meshOfLines({{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {0, 0, 1}}, {{0, 1}}}, 0.1, "test");
  ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_EQ(mesh.colors[i], mesh.positions[i].x < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1));
  }
}

TEST(MeshOfLines, LeavesOutWhatHasNoLength) {
  EXPECT_TRUE(meshOfLines({{{1, 1, 1}, {1, 1, 1}}, {}, {{0, 1}, {0, 0}}}, 0.1, "test").empty());
  const Mesh mesh = meshOfLines({{{0, 0, 0}, {1, 0, 0}}, {}, {{0, 0}, {0, 1}, {1, 1}}}, 0.1, "test");
  EXPECT_EQ(mesh.positions.size(), 18u);
  // The same segment twice turns back on itself.
  expectClosed(meshOfLines({{{0, 0, 0}, {1, 0, 0}}, {}, {{0, 1}, {0, 1}}}, 0.1, "test"));
}

TEST(MeshOfLines, RefusesCoordinatesThatAreNoNumbers) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(
      [&] {
        meshOfLines({{{0, 0, 0}, {none, 0, 0}}, {}, {{0, 1}}}, 0.1, "test");
      },
      ThrowsMessage<InputError>(HasSubstr("not a finite number")));
}

}  // namespace
}  // namespace ocelli
