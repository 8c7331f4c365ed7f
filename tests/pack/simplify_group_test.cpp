#include "oc_core/pack/simplify_group.h"

#include <gtest/gtest.h>

#include "oc_core/pack/open_edges.h"
#include "oc_core/pack/place_bits.h"
#include "tests/pack/packed_meshes.h"

namespace ocelli {
namespace {

using test::looseGrid;
using test::weldedOf;

constexpr int kGridSide = 24;

/// Places of the grid that lie on one of its sides.
size_t verticesOnSide(const WeldedTriangles& plane, bool (*isOnSide)(const glm::vec3& p)) {
  return static_cast<size_t>(std::ranges::count_if(plane.positions, isOnSide));
}

TEST(SimplifyGroup, APlaneLosesTrianglesWithItsRimAndWithoutError) {
  WeldedTriangles plane = weldedOf(looseGrid(kGridSide));
  float distance = 0;
  for (int step = 0; step < 7; ++step) {
    const std::optional<SimplifiedTriangles> coarse = simplified(plane, {});
    ASSERT_TRUE(coarse) << step;
    EXPECT_LT(coarse->triangles.triangleCount(), plane.triangleCount() * 6 / 10);
    EXPECT_NEAR(coarse->error.color, 0, 1e-6f);  // weights of corners do not add up to 1 exactly
    distance += coarse->error.distance;
    plane = coarse->triangles;
  }
  EXPECT_LE(plane.triangleCount(), 9U);
  EXPECT_NEAR(distance, 0, 1e-4f);
  double area = 0;
  for (size_t i = 0; i < plane.indices.size(); i += 3) {
    const glm::vec3& a = plane.positions[plane.indices[i]];
    area +=
        0.5 * static_cast<double>(
                  glm::cross(plane.positions[plane.indices[i + 1]] - a, plane.positions[plane.indices[i + 2]] - a).z);
  }
  EXPECT_NEAR(area, kGridSide * kGridSide, 1e-3);
}

TEST(SimplifyGroup, WhatIsSharedStaysVertexByVertex) {
  const auto isLeft = [](const glm::vec3& p) { return p.x == 0; };
  const auto isRight = [](const glm::vec3& p) { return p.x == kGridSide; };
  const WeldedTriangles plane = weldedOf(looseGrid(kGridSide));
  std::vector<PlaceBits> left;
  for (const glm::vec3& p : plane.positions) {
    if (isLeft(p)) {
      left.push_back(placeBits(p));
    }
  }
  const PlaceSet shared(left);
  WeldedTriangles coarse = plane;
  while (const std::optional<SimplifiedTriangles> next = simplified(coarse, shared)) {
    coarse = next->triangles;
  }
  EXPECT_LT(coarse.triangleCount(), 3 * kGridSide);
  EXPECT_EQ(verticesOnSide(coarse, isLeft), kGridSide + 1U);
  EXPECT_LT(verticesOnSide(coarse, isRight), kGridSide / 2U);
  // They are joined as they were, too.
  size_t edges = 0;
  for (const OpenEdge& edge : openEdges(coarse.indices, placeNumbers(coarse.positions))) {
    const glm::vec3& a = coarse.positions[edge.from];
    const glm::vec3& b = coarse.positions[edge.to];
    edges += isLeft(a) && isLeft(b) ? 1 : 0;
    EXPECT_TRUE(!(isLeft(a) && isLeft(b)) || std::abs(a.y - b.y) == 1);
  }
  EXPECT_EQ(edges, static_cast<size_t>(kGridSide));
}

/// A round hole, whose rim bends towards the surface: chords of it cover vertices of the rim that are left out, so that
/// these have no distance to the surface.
TEST(SimplifyGroup, AHoleThatBecomesSmallerIsAnError) {
  constexpr int kAround = 64;
  constexpr int kRings = 12;
  Mesh ring;
  for (int r = 0; r <= kRings; ++r) {
    for (int i = 0; i < kAround; ++i) {
      const float angle = 6.2831853f * static_cast<float>(i) / kAround;
      const float radius = 1 + static_cast<float>(r) / kRings;
      ring.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
      if (r < kRings) {
        const auto a = static_cast<uint32_t>(r * kAround + i);
        const auto b = static_cast<uint32_t>(r * kAround + (i + 1) % kAround);
        ring.triangles.emplace_back(a, a + kAround, b);
        ring.triangles.emplace_back(b, a + kAround, b + kAround);
      }
    }
  }
  WeldedTriangles coarse = weldedOf(ring);
  float distance = 0;
  for (int step = 0; step < 6; ++step) {
    if (const std::optional<SimplifiedTriangles> next = simplified(coarse, {})) {
      coarse = next->triangles;
      distance += next->error.distance;
    }
  }
  float nearest = 1;
  for (const OpenEdge& edge : openEdges(coarse.indices, placeNumbers(coarse.positions))) {
    nearest = std::min(nearest, glm::length((coarse.positions[edge.from] + coarse.positions[edge.to]) * 0.5f));
  }
  ASSERT_LT(coarse.triangleCount(), 80U);
  ASSERT_LT(nearest, 0.99f);
  // The vertex of the rim that was there lies within half a step of the middle of the chord.
  EXPECT_GE(distance, (1 - nearest) * 0.9f);
}

/// Two halves of a roof, each with one colour, so that the ridge has two vertices at each place. Whatever is left out
/// along the ridge lies on facets of both colours, or nearly.
TEST(SimplifyGroup, ACreaseBetweenTwoColorsIsNoErrorOfColor) {
  for (const float slope : {0.0f, 0.7f, -0.7f}) {
    Mesh roof = looseGrid(kGridSide);
    roof.colors.resize(roof.positions.size());
    for (const glm::uvec3& t : roof.triangles) {
      const bool isLeft =
          std::min({roof.positions[t.x].x, roof.positions[t.y].x, roof.positions[t.z].x}) < kGridSide / 2;
      for (glm::length_t k = 0; k < 3; ++k) {
        roof.colors[t[k]] = glm::vec3(isLeft ? 0.25f : 0.75f);
      }
    }
    for (glm::vec3& p : roof.positions) {
      // Not a straight line along the ridge, so that leaving out vertices moves it.
      p.z = -slope * std::abs(p.x - kGridSide / 2) + 0.02f * std::sin(1.3f * p.y);
    }
    WeldedTriangles coarse = weldedOf(roof);
    LevelError error;
    for (int step = 0; step < 7; ++step) {
      if (const std::optional<SimplifiedTriangles> next = simplified(coarse, {})) {
        coarse = next->triangles;
        error = {error.distance + next->error.distance, std::max(error.color, next->error.color)};
      }
    }
    EXPECT_LT(coarse.triangleCount(), 40U) << slope;
    EXPECT_LE(error.color, 1e-5f) << slope;
    EXPECT_LT(error.distance, 0.3f) << slope;
  }
}

TEST(SimplifyGroup, AColorThatIsLostIsAnError) {
  WeldedTriangles plane = weldedOf(looseGrid(24));
  for (size_t i = 0; i < plane.positions.size(); ++i) {
    plane.colors[i] = packedColor(glm::vec3(i % 2 == 0 ? 1.0f : 0.25f));
  }
  const std::optional<SimplifiedTriangles> coarse = simplified(plane, {});
  ASSERT_TRUE(coarse);
  // Some vertex with 0.25 lies on a triangle of full light, or the other way round; no side is shorter than 1.
  EXPECT_GT(coarse->error.color, 0.75f / 3);
}

TEST(SimplifyGroup, TrianglesWithoutNeighborsStay) {
  Mesh loose;
  for (int i = 0; i < 300; ++i) {
    const auto x = static_cast<float>(i);
    loose.positions.insert(loose.positions.end(), {{x, 0, 0}, {x + 0.5f, 0, 0}, {x, 0.5f, 0}});
    const auto first = static_cast<uint32_t>(3 * i);
    loose.triangles.emplace_back(first, first + 1, first + 2);
  }
  EXPECT_FALSE(simplified(weldedOf(loose), {}));
}

}  // namespace
}  // namespace ocelli
