#include "oc_core/camera/ray_hull.h"

#include <gtest/gtest.h>

#include "tests/camera/random_curved_cameras.h"

namespace ocelli {
namespace {

using test::Numbers;

/// Rays are in single precision, some 20 units long.
constexpr double kHullRounding = 1e-4;

/// Whether no plane of many parts the point from the piece.
bool mayHold(std::span<const glm::dvec3> piece, const glm::dvec3& point, std::span<const glm::dvec3> normals) {
  return std::all_of(normals.begin(), normals.end(), [&](const glm::dvec3& normal) {
    double farthest = -1e300;
    for (const glm::dvec3& corner : piece) {
      farthest = std::max(farthest, glm::dot(normal, corner));
    }
    return glm::dot(normal, point) <= farthest + kHullRounding;
  });
}

template <class C>
void expectRaysInHull(const C& camera, Numbers& numbers) {
  const glm::dvec2 size(camera.width(), camera.height());
  // One number a statement: the same with any compiler.
  glm::dvec2 lower;
  lower.x = numbers.between(0, 0.8) * size.x;
  lower.y = numbers.between(0, 0.8) * size.y;
  glm::dvec2 upper;
  upper.x = std::min(lower.x + numbers.between(1, 30), size.x);
  upper.y = std::min(lower.y + numbers.between(1, 30), size.y);
  const HullPieces hull = hullOf(camera, lower, upper);
  std::vector<glm::dvec3> normals;
  for (int i = 0; i < 100; ++i) {
    normals.push_back(glm::normalize(test::randomVector(numbers, 1)));
  }
  for (int i = 0; i < 20; ++i) {
    glm::dvec2 exact;
    exact.x = numbers.between(lower.x, upper.x);
    exact.y = numbers.between(lower.y, upper.y);
    const glm::vec2 pixel(exact);
    for (const glm::vec3& point : camera.rayPath(pixel)) {
      bool isHeld = false;
      for (size_t piece = 0; piece < hull.ends.size() && !isHeld; ++piece) {
        isHeld = mayHold(hull.piece(piece), glm::dvec3(point), normals);
      }
      ASSERT_TRUE(isHeld) << "a point of the ray of pixel " << pixel.x << ", " << pixel.y;
    }
  }
}

TEST(RayHull, HoldsTheRaysOfAPinhole) {
  Numbers numbers;
  for (int i = 0; i < 100; ++i) {
    expectRaysInHull(test::smallCamera(), numbers);
  }
}

TEST(RayHull, HoldsTheRaysOfCurvedRayCameras) {
  Numbers numbers;
  int bent = 0;
  for (int i = 0; i < 200; ++i) {
    const CurvedRayCamera camera = test::randomCurved(numbers, 1 + i % 3);
    bent += camera.bends().empty() ? 0 : 1;
    expectRaysInHull(camera, numbers);
  }
  EXPECT_GT(bent, 150);
}

// Each piece is no larger than it has to be: its points lie on rays of the corners.
TEST(RayHull, OfACornerIsItsRay) {
  Numbers numbers;
  const CurvedRayCamera camera = test::randomCurved(numbers, 1);
  ASSERT_EQ(camera.bends().size(), 1u);
  const HullPieces hull = hullOf(camera, {10, 10}, {10, 10});
  ASSERT_EQ(hull.ends.size(), 3u);
  const RayPath path = camera.rayPath({10, 10});
  EXPECT_LT(glm::distance(glm::vec3(hull.points.front()), path.front()), 1e-4f);
  EXPECT_LT(glm::distance(glm::vec3(hull.piece(1).front()), path[1]), 1e-4f) << "where the arc begins";
  EXPECT_LT(glm::distance(glm::vec3(hull.piece(1).back()), path[path.size() - 2]), 1e-4f) << "where it ends";
}

TEST(RayHull, IsMissingWhereACameraHasNone) {
  EXPECT_FALSE(rayHullOf(std::make_shared<const int>(1)));
  EXPECT_TRUE(rayHullOf(std::make_shared<const PinholeCamera>(test::smallCamera())));
}

}  // namespace
}  // namespace ocelli
