#include "oc_core/ocri/corner_depth_images.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::sameBytes;
using test::smallCamera;

/// The default view looks along -z, with x to the right and y up.
bool isCorner(const glm::vec3& eye, float half) {
  const glm::vec3 offset = glm::abs(eye - View{}.eye);
  return glm::distance(offset, glm::vec3(half)) < 1e-5f;
}

TEST(CornerDepthImages, eightCornersAreTheCorners) {
  const ReferenceImages images = buildCornerDepthImages(smallCamera(), test::boxBeforeWall(), ViewCell{2}, 8);
  ASSERT_EQ(images.size(), 9u);
  EXPECT_EQ(images[0].view, View{});
  for (size_t i = 1; i < images.size(); ++i) {
    EXPECT_TRUE(isCorner(images[i].view.eye, 1));
    for (size_t j = 1; j < i; ++j) {
      EXPECT_GT(glm::distance(images[i].view.eye, images[j].view.eye), 1.9f);
    }
  }
}

TEST(CornerDepthImages, fourCornersAreThoseTowardsTheScene) {
  const ReferenceImages images = buildCornerDepthImages(smallCamera(), test::boxBeforeWall(), ViewCell{2}, 4);
  ASSERT_EQ(images.size(), 5u);
  for (size_t i = 1; i < images.size(); ++i) {
    EXPECT_TRUE(isCorner(images[i].view.eye, 1));
    EXPECT_LT(images[i].view.eye.z, View{}.eye.z);
  }
}

TEST(CornerDepthImages, eachIsTheDepthImageOfItsView) {
  const Mesh scene = test::ballBeforePlane();
  for (const ReferenceImage& image : buildCornerDepthImages(smallCamera(), scene, ViewCell{}, 4)) {
    const ReferenceImage expected = buildDepthImage(image.reference(), scene);
    EXPECT_TRUE(sameBytes(image.t, expected.t));
    EXPECT_TRUE(sameBytes(image.color, expected.color));
    EXPECT_EQ(image.view.resolvedFovVerticalDegrees(), View{}.resolvedFovVerticalDegrees());
  }
}

TEST(CornerDepthImages, refusesOtherCounts) {
  for (const int count : {-4, 0, 1, 5, 9}) {
    EXPECT_THROW(buildCornerDepthImages(smallCamera(), test::wall(0), ViewCell{}, count), InputError);
  }
  for (const ViewCell::Shape shape : {ViewCell::Shape::kSphere, ViewCell::Shape::kSegment}) {
    EXPECT_THROW(buildCornerDepthImages(smallCamera(), test::wall(0), ViewCell{1.6f, shape}, 8), InputError);
  }
}

}  // namespace
}  // namespace ocelli
