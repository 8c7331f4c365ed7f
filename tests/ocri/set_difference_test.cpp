#include "oc_core/ocri/set_difference.h"

#include <gtest/gtest.h>

#include "oc_core/ocri/ddoc_builder.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

template <Camera C>
Projection projectionOf(const C& camera) {
  return [&camera](const glm::vec3& point) { return camera.project(point); };
}

SetDifferenceOptions withoutSeams() {
  return {.seamPixels = 0};
}

TEST(SetDifference, imageMinusItselfIsEmpty) {
  const PinholeCamera camera = smallCamera();
  const ReferenceImage image = buildDepthImage(camera, test::boxBeforeWall());
  ReferenceImage difference = image;
  EXPECT_EQ(subtract(difference, image, projectionOf(camera)), 0u);
}

TEST(SetDifference, imageMinusNothingStays) {
  const PinholeCamera camera = smallCamera();
  ReferenceImage image = buildDepthImage(camera, test::boxBeforeWall());
  const size_t samples = image.sampleCount();
  const ReferenceImage empty = buildDepthImage(camera, {});
  EXPECT_EQ(subtract(image, empty, projectionOf(camera)), samples);
}

// A wall of 3x3 units fills both images. The right one is moved by one unit, which is 1 * f / z pixels: as many columns
// does it show that the left one does not.
TEST(SetDifference, movedViewAddsTheColumnsThatComeIn) {
  const Mesh wall = test::wall(0);
  const PinholeCamera left = smallCamera();
  View moved = left.view();
  moved.fovVerticalDegrees = moved.resolvedFovVerticalDegrees();
  moved.eye.x += 0.1f;
  moved.target.x += 0.1f;
  const PinholeCamera right(moved, kWidth, kHeight);
  const ReferenceImage held = buildDepthImage(left, wall);
  ReferenceImage added = buildDepthImage(right, wall);
  const double columns = 0.1 * left.focalPixels() / 10;
  ASSERT_GT(columns, 2);
  const auto least = static_cast<size_t>(std::floor(columns - 1.5)) * kHeight;  // 1.5 footprints count as held
  const auto most = static_cast<size_t>(std::ceil(columns)) * kHeight;
  const size_t left0 = subtract(added, held, projectionOf(left), withoutSeams());
  EXPECT_GE(left0, least);
  EXPECT_LE(left0, most);
  for (int y = 0; y < kHeight; ++y) {
    EXPECT_EQ(added.t(kWidth / 2, y), 0);
    EXPECT_GT(added.t(kWidth - 1, y), 0);
  }
}

TEST(SetDifference, seamsReachAPixelIntoWhatIsHeld) {
  const Mesh wall = test::wall(0);
  const PinholeCamera camera = smallCamera();
  const ReferenceImage image = buildDepthImage(camera, wall);
  ReferenceImage held = image;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 40; x < kWidth; ++x) {
      held.clear(held.t.index(x, y));
    }
  }
  const auto columnsLeft = [&](int seamPixels) {
    ReferenceImage difference = image;
    return subtract(difference, held, projectionOf(camera), {.seamPixels = seamPixels}) / kHeight;
  };
  // The sample at column 40 has its neighbour 39 within 1.5 footprints, so 41 is the first that is missing.
  EXPECT_EQ(columnsLeft(0), static_cast<size_t>(kWidth - 41));
  EXPECT_EQ(columnsLeft(1), static_cast<size_t>(kWidth - 40));
  EXPECT_EQ(columnsLeft(3), static_cast<size_t>(kWidth - 38));
}

TEST(SetDifference, seamsStayOnTheirSurface) {
  const PinholeCamera camera = smallCamera();
  ReferenceImage image = buildDepthImage(camera, test::boxBeforeWall());
  ReferenceImage held = image;
  for (float& z : held.t) {  // the wall alone is held
    z = z > 10.5f ? z : 0;
  }
  subtract(image, held, projectionOf(camera), {.seamPixels = 3});
  for (const float z : image.t) {
    EXPECT_LT(z, 10.5f);
  }
  EXPECT_GT(image.sampleCount(), 100u);
}

TEST(SetDifference, occlusionCameraAddsOnlyWhatThePinholeHides) {
  const Mesh mesh = test::boxBeforeWall();
  const PinholeCamera pinhole = smallCamera();
  const DdocCamera ddoc = buildDdocCamera(pinhole, mesh);
  const ReferenceImage depth = buildDepthImage(pinhole, mesh);
  const ReferenceImage ocri = buildDdocImage(ddoc, mesh);
  ReferenceImage added = ocri;
  const size_t left = subtract(added, depth, projectionOf(pinhole), withoutSeams());
  EXPECT_GT(left, 50u);
  EXPECT_LT(left, ocri.sampleCount() / 5);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (added.holds(x, y)) {
        const ImagePoint q = added.undistorted(x, y);
        const float front = depth.t(static_cast<int>(q.u), static_cast<int>(q.v));
        EXPECT_GT(q.t, front - 0.05f) << "nothing in front of what the pinhole sees";
      }
    }
  }
  // The other way round, through the projection of the occlusion camera: little is lost.
  ReferenceImage lost = depth;
  EXPECT_LT(subtract(lost, ocri, projectionOf(ddoc), withoutSeams()), depth.sampleCount() / 20);
}

TEST(SetDifference, projectionsThatFailHoldNothing) {
  const PinholeCamera camera = smallCamera();
  const ReferenceImage image = buildDepthImage(camera, test::wall(0));
  for (const std::optional<ImagePoint>& nowhere : {std::optional<ImagePoint>{}, std::optional(ImagePoint{1e30f, 5, 10}),
                                                   std::optional(ImagePoint{5, -1e9f, 10})}) {
    ReferenceImage difference = image;
    EXPECT_EQ(subtract(difference, image, [&](const glm::vec3&) { return nowhere; }), image.sampleCount());
  }
}

}  // namespace
}  // namespace ocelli
