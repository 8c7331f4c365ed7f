#include "oc_core/ocri/spoc_builder.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_subdivided.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

// A box in the middle, its front at 9.3, before a wall at 10.9: the pole is the middle of the box.
TEST(SpocBuilder, poleStandsOnTheForeground) {
  const SpocCamera camera = buildSpocCamera(smallCamera(), test::boxBeforeWall());
  // Pixel centres are symmetric around the middle (45, 30).
  EXPECT_NEAR(camera.distortion().pole.x, 45, 1e-3f);
  EXPECT_NEAR(camera.distortion().pole.y, 30, 1e-3f);
  EXPECT_NEAR(camera.distortion().zNear, 10 - test::kBoxFrontZ, 1e-4f);
  EXPECT_NEAR(camera.distortion().zFar, 10 - test::kWallZ, 1e-4f);

  Mesh aside = test::wall(-1);
  test::addQuad(aside, {0.5f, 0, 0.5f}, {0.9f, 0, 0.5f}, {0.9f, 0.4f, 0.5f}, {0.5f, 0.4f, 0.5f});
  const ImagePoint middle = *smallCamera().project({0.7f, 0.2f, 0.5f});
  const glm::vec2 pole = buildSpocCamera(smallCamera(), aside).distortion().pole;
  // The centroid of whole pixels: a row or column more on one side moves it by half a pixel.
  EXPECT_NEAR(pole.x, middle.u, 0.51f);
  EXPECT_NEAR(pole.y, middle.v, 0.51f);
}

/// Pixels that show a point of a box's sides: not its front, nor the wall.
size_t sidesShown(const FragmentImage& image, const Mesh& mesh) {
  return static_cast<size_t>(std::count_if(image.begin(), image.end(), [&](const Fragment& f) {
    const float z = f.covered() ? positionOf(f, mesh).z : 0;
    return z > test::kWallZ + 0.01f && z < test::kBoxFrontZ - 0.01f && f.covered();
  }));
}

// "The SPOC image captures 5 of 6 faces for the cube and the entire background" (Figure 3.6), as the reverse pinhole
// does, while a pinhole in front of a box sees its front alone.
TEST(SpocBuilder, bothCamerasSeeTheSidesOfABox) {
  const Mesh mesh = test::boxBeforeWall();
  EXPECT_EQ(sidesShown(rasterize(smallCamera(), mesh), mesh), 0u);
  const SpocCamera spoc = buildSpocCamera(smallCamera(), mesh);
  // The front is 19 pixels wide. By Equation 3.1 the back stands out by 1.9 pixels, in the reverse pinhole by half a
  // pixel: so much of a ring of 76 pixels or more, whole rows and columns of it.
  EXPECT_GT(sidesShown(rasterize(spoc, mesh), mesh), 76u);
  EXPECT_GT(sidesShown(rasterize(buildReversePinhole(smallCamera(), mesh), mesh), mesh), 38u);
  // No hole at the pole, which the front of the box masks.
  EXPECT_EQ(buildSpocImage(spoc, mesh).sampleCount(), static_cast<size_t>(test::kWidth * test::kHeight));
}

TEST(SpocBuilder, samplesUnprojectToTheirSurface) {
  const Mesh mesh = test::boxBeforeWall();
  const auto check = [&](const ReferenceImage& image) {
    const PinholeCamera reference = image.reference();
    size_t wall = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (!image.holds(x, y)) {
          continue;
        }
        const glm::vec3 p = *reference.unproject(image.undistorted(x, y));
        const bool onWall = std::abs(p.z - test::kWallZ) < 1e-3f;
        const glm::vec3 inBox = glm::abs(p - glm::vec3(0, 0, test::kBoxFrontZ - test::kBoxHalf)) - test::kBoxHalf;
        const bool onBox = std::abs(std::max({inBox.x, inBox.y, inBox.z})) < 1e-3f;
        wall += onWall;
        EXPECT_TRUE(onWall || onBox) << p.x << " " << p.y << " " << p.z;
      }
    }
    EXPECT_GT(wall, 100u);
    EXPECT_GT(image.triangleBound, 0u);
    EXPECT_LE(imageMesh(image).triangles.size(), image.triangleBound);
  };
  check(buildSpocImage(buildSpocCamera(smallCamera(), mesh), mesh));
  check(buildReversePinholeImage(buildReversePinhole(smallCamera(), mesh), smallCamera(), mesh));
}

TEST(SpocBuilder, scenesWithoutDepthOrOutOfViewAreRefused) {
  EXPECT_THROW(buildSpocCamera(smallCamera(), test::wall(0, 1)), InputError);
  EXPECT_THROW(buildSpocCamera(smallCamera(), Mesh{}), InputError);
  EXPECT_THROW(buildReversePinhole(smallCamera(), Mesh{}), InputError);
  EXPECT_NO_THROW(buildReversePinhole(smallCamera(), test::wall(0, 1)));
}

}  // namespace
}  // namespace ocelli
