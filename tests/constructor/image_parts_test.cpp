#include "oc_core/constructor/image_parts.h"

#include <gtest/gtest.h>

#include "oc_core/base/random.h"

namespace ocelli {
namespace {

using Part = GraphCamera::Part;

const Part kSquare{{10, 10}, {30, 10}, {30, 30}, {10, 30}};

double areaOf(const Part& part) {
  double twice = 0;
  for (size_t i = 0; i < part.size(); ++i) {
    const glm::dvec2& a = part[i];
    const glm::dvec2& b = part[(i + 1) % part.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

double areaOf(const std::vector<Part>& parts) {
  double area = 0;
  for (const Part& part : parts) {
    area += areaOf(part);
  }
  return area;
}

/// Seen from the origin along -z: a focal length of 50 pixels, the middle of the image at (50, 50).
PinholeCamera camera(float zNear = 1, float zFar = 10) {
  View view;
  view.eye = {0, 0, 0};
  view.target = {0, 0, -1};
  view.fovVerticalDegrees = 90;
  view.zNear = zNear;
  view.zFar = zFar;
  return {view, 100, 100};
}

/// A square of side 2 across the view, the other way around where `reversed`.
std::vector<glm::dvec3> squareAt(double x, double z, bool reversed = false) {
  std::vector<glm::dvec3> corners{{x - 1, -1, -z}, {x + 1, -1, -z}, {x + 1, 1, -z}, {x - 1, 1, -z}};
  if (reversed) {
    std::swap(corners[1], corners[3]);
  }
  return corners;
}

TEST(ImageParts, aSquareIsSeenWhereThePinholePutsIt) {
  for (const bool reversed : {false, true}) {
    const Part part = imagePart(squareAt(0, 5, reversed), camera());
    ASSERT_EQ(part.size(), 4u);
    EXPECT_NEAR(areaOf(part), 400, 1e-3);  // 2 / 5 of the focal length a side; positive: clockwise as seen
    for (const glm::dvec2& corner : part) {
      EXPECT_NEAR(std::abs(corner.x - 50), 10, 1e-4);
      EXPECT_NEAR(std::abs(corner.y - 50), 10, 1e-4);
    }
  }
}

TEST(ImageParts, partsEndAtTheBordersAndAtTheDepthsOfTheView) {
  EXPECT_NEAR(areaOf(imagePart(squareAt(5, 5), camera())), 200, 1e-3);
  EXPECT_TRUE(imagePart(squareAt(6.5, 5), camera()).empty());
  EXPECT_TRUE(imagePart(squareAt(0, 0.5), camera()).empty());
  EXPECT_TRUE(imagePart(squareAt(0, 11), camera()).empty());
  EXPECT_TRUE(imagePart(squareAt(0, -5), camera()).empty());
  // A floor that runs through the eye's plane: seen between zNear and zFar.
  const std::vector<glm::dvec3> floor{{-1, -1, 5}, {1, -1, 5}, {1, -1, -50}, {-1, -1, -50}};
  double bottom = 0;
  double top = 100;
  for (const glm::dvec2& corner : imagePart(floor, camera(2))) {
    bottom = std::max(bottom, corner.y);
    top = std::min(top, corner.y);
  }
  EXPECT_NEAR(bottom, 50 + 50 / 2.0, 0.1);
  EXPECT_NEAR(top, 50 + 50 / 10.0, 0.1);
}

TEST(ImageParts, whatIsEdgeOnIsEmpty) {
  const std::vector<glm::dvec3> edge{{0, -1, -5}, {0, -1, -8}, {0, 1, -8}, {0, 1, -5}};
  EXPECT_TRUE(imagePart(edge, camera()).empty());
  EXPECT_TRUE(imagePart({}, camera()).empty());
}

TEST(ImageParts, commonAndLessMakeUpThePart) {
  const Part corner{{20, 20}, {50, 20}, {50, 50}, {20, 50}};
  EXPECT_NEAR(areaOf(common(kSquare, corner)), 100, 1e-9);
  EXPECT_NEAR(areaOf(less(kSquare, corner)), 300, 1e-9);
  const Part inside{{15, 15}, {20, 15}, {20, 20}, {15, 20}};
  EXPECT_NEAR(areaOf(less(kSquare, inside)), 375, 1e-9);
  EXPECT_TRUE(less(inside, kSquare).empty());
  const Part beside{{30, 10}, {50, 10}, {50, 30}, {30, 30}};
  EXPECT_TRUE(common(kSquare, beside).empty());
  ASSERT_EQ(less(kSquare, beside).size(), 1u);
  EXPECT_EQ(less(kSquare, beside).front(), kSquare);
  EXPECT_TRUE(common(kSquare, {}).empty());
  EXPECT_TRUE(less({}, kSquare).empty());
}

TEST(ImageParts, randomPartsAddUp) {
  Random random(5);
  const auto triangle = [&] {
    Part part;
    for (int i = 0; i < 3; ++i) {
      const float x = random.inRange(0, 100);
      part.emplace_back(x, random.inRange(0, 100));
    }
    if (areaOf(part) < 0) {
      std::swap(part[0], part[1]);
    }
    return part;
  };
  for (int i = 0; i < 2000; ++i) {
    const Part a = triangle();
    const Part b = triangle();
    const std::vector<Part> rest = less(a, b);
    // Left out: pieces below a thousandth of a square pixel, and slivers beside corners that were made one.
    EXPECT_NEAR(areaOf(common(a, b)) + areaOf(rest), areaOf(a), 0.1);
    for (const Part& piece : rest) {
      EXPECT_NEAR(areaOf(common(piece, b)), 0, 1e-3);
    }
  }
}

}  // namespace
}  // namespace ocelli
