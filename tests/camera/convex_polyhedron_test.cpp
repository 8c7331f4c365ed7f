#include "oc_core/camera/convex_polyhedron.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "tests/camera/inverse_errors.h"

namespace ocelli {
namespace {

using test::Numbers;

ConvexPolyhedron unitCube() {
  return {glm::dvec3(0), glm::dvec3(1)};
}

/// The unit cube without what lies on the side of a plane through `point` that `normal` points to.
ConvexPolyhedron cubeCut(const glm::dvec3& point, const glm::dvec3& normal) {
  ConvexPolyhedron cube = unitCube();
  cube.cut(Plane::through(point, normal));
  return cube;
}

void expectBounds(const ConvexPolyhedron& polyhedron, const glm::dvec3& lower, const glm::dvec3& upper) {
  ASSERT_FALSE(polyhedron.empty());
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(polyhedron.lower()[k], lower[k], 1e-12);
    EXPECT_NEAR(polyhedron.upper()[k], upper[k], 1e-12);
  }
}

TEST(ConvexPolyhedron, isTheBoxThatItIsMadeOf) {
  const ConvexPolyhedron box({-1, 2, 3}, {5, 4, 3.5});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.lower(), glm::dvec3(-1, 2, 3));
  EXPECT_EQ(box.upper(), glm::dvec3(5, 4, 3.5));
  EXPECT_EQ(box.middle(), glm::dvec3(2, 3, 3.25));
}

TEST(ConvexPolyhedron, planesBesideItTakeNothingOrAll) {
  const ConvexPolyhedron whole = cubeCut({0, 0, 1.5}, {0.2, 0, 1});
  expectBounds(whole, glm::dvec3(0), glm::dvec3(1));
  EXPECT_EQ(whole.middle(), glm::dvec3(0.5));
  EXPECT_TRUE(cubeCut({0, 0, 1.5}, {-0.2, 0, -1}).empty());
}

// Each corner is on three faces, that of the cut among them: the mean is that of the eight corners.
TEST(ConvexPolyhedron, cutAcrossIsABox) {
  const ConvexPolyhedron half = cubeCut({0.5, 0, 0}, {1, 0, 0});
  expectBounds(half, glm::dvec3(0), {0.5, 1, 1});
  EXPECT_LT(glm::distance(half.middle(), glm::dvec3(0.25, 0.5, 0.5)), 1e-12);
}

// Three squares, three halves of squares and the triangle of the cut: 24 corners, of which 11 have a 1 in each axis.
TEST(ConvexPolyhedron, aCornerIsCutOff) {
  const ConvexPolyhedron rest = cubeCut({1, 1, 0}, {1, 1, 1});
  expectBounds(rest, glm::dvec3(0), glm::dvec3(1));
  EXPECT_LT(glm::distance(rest.middle(), glm::dvec3(11.0 / 24)), 1e-12);
  expectBounds(cubeCut({0.5, 0, 0}, {1, 1, 1}), glm::dvec3(0), glm::dvec3(0.5));
}

TEST(ConvexPolyhedron, planesMayTouchACorner) {
  expectBounds(cubeCut(glm::dvec3(1), {1, 1, 1}), glm::dvec3(0), glm::dvec3(1));
  const ConvexPolyhedron corner = cubeCut(glm::dvec3(1), {-1, -1, -1});
  expectBounds(corner, glm::dvec3(1), glm::dvec3(1));
  EXPECT_EQ(corner.middle(), glm::dvec3(1));
}

TEST(ConvexPolyhedron, planesMayTouchAnEdge) {
  expectBounds(cubeCut({1, 1, 0}, {1, 1, 0}), glm::dvec3(0), glm::dvec3(1));
  const ConvexPolyhedron edge = cubeCut({1, 1, 0}, {-1, -1, 0});
  expectBounds(edge, {1, 1, 0}, glm::dvec3(1));
  EXPECT_LT(glm::distance(edge.middle(), glm::dvec3(1, 1, 0.5)), 1e-12);
}

TEST(ConvexPolyhedron, planesMayTouchAFace) {
  expectBounds(cubeCut({0, 1, 0}, {0, 1, 0}), glm::dvec3(0), glm::dvec3(1));
  const ConvexPolyhedron face = cubeCut({0, 1, 0}, {0, -1, 0});
  expectBounds(face, {0, 1, 0}, glm::dvec3(1));
  EXPECT_LT(glm::distance(face.middle(), glm::dvec3(0.5, 1, 0.5)), 1e-12);
}

TEST(ConvexPolyhedron, planesMayPassThroughTwoEdges) {
  const ConvexPolyhedron wedge = cubeCut(glm::dvec3(0), {1, -1, 0});
  expectBounds(wedge, glm::dvec3(0), glm::dvec3(1));
  const glm::dvec3 middle = wedge.middle();
  EXPECT_LT(middle.x, middle.y - 0.1) << "well within";
  EXPECT_NEAR(middle.z, 0.5, 1e-12);
}

// What one cut leaves is closed: the next cuts the face that the first one made.
TEST(ConvexPolyhedron, cutsFollowEachOther) {
  ConvexPolyhedron cube = unitCube();
  cube.cut(Plane::through({0.5, 0, 0}, {1, 0, 0}));
  cube.cut(Plane::through({0, 0, 0.25}, {0, 0, 1}));
  cube.cut(Plane::through({0.25, 0, 0}, {-1, 0, 0}));
  expectBounds(cube, {0.25, 0, 0}, {0.5, 1, 0.25});
  EXPECT_LT(glm::distance(cube.middle(), glm::dvec3(0.375, 0.5, 0.125)), 1e-12);
  cube.cut(Plane::through({0.5, 0, 0}, {-1, 0, 0}));
  expectBounds(cube, {0.5, 0, 0}, {0.5, 1, 0.25});
  cube.cut(Plane::through({0.6, 0, 0}, {-1, 0, 0}));
  EXPECT_TRUE(cube.empty());
  cube.cut(Plane::through({0, 0, 0}, {1, 0, 0}));
  EXPECT_TRUE(cube.empty()) << "of nothing nothing is left";
}

TEST(ConvexPolyhedron, boxesMayBeFlat) {
  ConvexPolyhedron flat({0, 0, 2}, {1, 1, 2});
  flat.cut(Plane::through({0, 0, 2}, {0, 0, 1}));
  flat.cut(Plane::through({0, 0, 2}, {0, 0, -1}));
  expectBounds(flat, {0, 0, 2}, {1, 1, 2});
  flat.cut(Plane::through({0.5, 0, 0}, {1, 0, 0}));
  expectBounds(flat, {0, 0, 2}, {0.5, 1, 2});
  flat.cut(Plane::through({0, 0, 3}, {0, 0, -1}));
  EXPECT_TRUE(flat.empty());
}

TEST(ConvexPolyhedron, boxesMayBeLinesOrPoints) {
  ConvexPolyhedron line({0, 3, 2}, {1, 3, 2});
  line.cut(Plane::through({0.75, 3, 2}, {-1, 0.5, 0}));
  expectBounds(line, {0.75, 3, 2}, {1, 3, 2});
  EXPECT_LT(glm::distance(line.middle(), glm::dvec3(0.875, 3, 2)), 0.126);
  ConvexPolyhedron point(glm::dvec3(1, 2, 3), glm::dvec3(1, 2, 3));
  point.cut(Plane::through({0, 0, 4}, {0, 0, 1}));
  expectBounds(point, {1, 2, 3}, {1, 2, 3});
  point.cut(Plane::through({0, 0, 4}, {0, 0, -1}));
  EXPECT_TRUE(point.empty());
}

/// The corners of what lies behind all planes: where three of them meet, and no other is before it. Slow and obvious.
std::vector<glm::dvec3> cornersBehind(const std::vector<Plane>& planes) {
  std::vector<glm::dvec3> corners;
  for (size_t i = 0; i < planes.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      for (size_t k = 0; k < j; ++k) {
        const glm::dmat3 normals = glm::transpose(glm::dmat3(planes[i].normal, planes[j].normal, planes[k].normal));
        if (std::abs(glm::determinant(normals)) < 1e-9) {
          continue;
        }
        const glm::dvec3 corner =
            glm::inverse(normals) * glm::dvec3(planes[i].distance, planes[j].distance, planes[k].distance);
        if (std::all_of(planes.begin(), planes.end(),
                        [&](const Plane& plane) { return plane.height(corner) < 1e-9; })) {
          corners.push_back(corner);
        }
      }
    }
  }
  return corners;
}

TEST(ConvexPolyhedron, hasTheCornersWhereThreePlanesMeet) {
  Numbers numbers;
  const auto randomVector = [&] {
    const double x = numbers.between(-1, 1);
    const double y = numbers.between(-1, 1);
    return glm::dvec3(x, y, numbers.between(-1, 1));
  };
  int emptied = 0;
  for (int n = 0; n < 300; ++n) {
    ConvexPolyhedron polyhedron(glm::dvec3(-1), glm::dvec3(1));
    std::vector<Plane> planes{{{1, 0, 0}, 1},  {{0, 1, 0}, 1},  {{0, 0, 1}, 1},
                              {{-1, 0, 0}, 1}, {{0, -1, 0}, 1}, {{0, 0, -1}, 1}};
    for (int k = 0; k < 6; ++k) {
      planes.push_back(Plane::through(randomVector() * 0.9, randomVector()));
      polyhedron.cut(planes.back());
      const std::vector<glm::dvec3> corners = cornersBehind(planes);
      ASSERT_EQ(polyhedron.empty(), corners.empty()) << n << ", " << k;
      if (corners.empty()) {
        ++emptied;
        break;
      }
      glm::dvec3 lower(std::numeric_limits<double>::infinity());
      glm::dvec3 upper(-lower);
      for (const glm::dvec3& corner : corners) {
        lower = glm::min(lower, corner);
        upper = glm::max(upper, corner);
      }
      ASSERT_LT(glm::distance(polyhedron.lower(), lower), 1e-7) << n << ", " << k;
      ASSERT_LT(glm::distance(polyhedron.upper(), upper), 1e-7) << n << ", " << k;
      for (const Plane& plane : planes) {
        ASSERT_LT(plane.height(polyhedron.middle()), 0) << n << ", " << k;
      }
    }
  }
  EXPECT_GT(emptied, 30);
  EXPECT_LT(emptied, 270);
}

}  // namespace
}  // namespace ocelli
