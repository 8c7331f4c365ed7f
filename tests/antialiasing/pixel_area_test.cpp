// Averages by area against areas by hand, and against many samples.
#include <gtest/gtest.h>

#include "oc_core/base/random.h"
#include "tests/antialiasing/antialias_scenes.h"

namespace ocelli::test {
namespace {

constexpr glm::vec3 kRed(1, 0, 0);
constexpr glm::vec3 kGreen(0, 1, 0);

glm::vec3 areaPixel(const Mesh& mesh, const PinholeCamera& camera, const glm::ivec2& pixel) {
  AntialiasWork work;
  const Image<glm::vec3> image =
      AntialiasScene(camera, mesh).draw(everywhere(squareRule(1, "grid", 16)), glm::vec3(0), &work);
  EXPECT_EQ(work.sampled, 0U);
  return image(pixel.x, pixel.y);
}

TEST(PixelArea, ofATriangleWithinAPixel) {
  const PinholeCamera camera = flatCamera(8, 8);
  Mesh mesh;
  addFlat(mesh, {3.25f, 4.25f}, {3.75f, 4.25f}, {3.25f, 4.75f}, kRed, camera);
  // Half of 0.5 x 0.5, at corners on the grid of 1/4096 pixel but for the rounding of their projection.
  EXPECT_NEAR(areaPixel(mesh, camera, {3, 4}).x, 0.125, 5e-4);
}

TEST(PixelArea, ofATriangleOverSeveralPixels) {
  const PinholeCamera camera = flatCamera(8, 8);
  Mesh mesh;  // below the line v = u, far beyond the image
  addFlat(mesh, {-16, -16}, {32, 32}, {-16, 32}, kRed, camera);
  EXPECT_NEAR(areaPixel(mesh, camera, {3, 3}).x, 0.5, 1e-3);
  EXPECT_EQ(areaPixel(mesh, camera, {3, 4}).x, 1);
  EXPECT_EQ(areaPixel(mesh, camera, {4, 3}).x, 0);
}

TEST(PixelArea, theNearerHidesTheFarther) {
  const PinholeCamera camera = flatCamera(8, 8);
  Mesh mesh;
  // Left half of the pixel (3, 3) red, farther; its lower half green, nearer.
  addFlat(mesh, {-9, -40}, {3.5f, -40}, {3.5f, 80}, kRed, camera, 1);
  addFlat(mesh, {-9, -40}, {3.5f, 80}, {-9, 80}, kRed, camera, 1);
  addFlat(mesh, {-40, 3.5f}, {60, 3.5f}, {-40, 60}, kGreen, camera, 2);
  const glm::vec3 color = areaPixel(mesh, camera, {3, 3});
  EXPECT_NEAR(color.x, 0.25, 1e-3);
  EXPECT_NEAR(color.y, 0.5, 1e-3);
}

TEST(PixelArea, surfacesThatCrossShareThePixel) {
  View view;
  view.eye = {0, 0, 4};
  view.fovVerticalDegrees = 40;
  const PinholeCamera camera(view, 1, 1);
  Mesh mesh;  // two planes that cross along x = 0, seen from the front: each is nearer on one side
  mesh.positions = {{-8, -8, -4}, {8, -8, 4}, {8, 8, 4}, {-8, 8, -4}, {-8, -8, 4}, {8, -8, -4}, {8, 8, -4}, {-8, 8, 4}};
  mesh.colors = {kRed, kRed, kRed, kRed, kGreen, kGreen, kGreen, kGreen};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const glm::vec3 color = areaPixel(mesh, camera, {0, 0});
  EXPECT_NEAR(color.x, 0.5, 1e-3);
  EXPECT_NEAR(color.y, 0.5, 1e-3);
}

TEST(PixelArea, agreesWithManySamples) {
  Random random(11);
  const PinholeCamera camera = flatCamera(8, 8);
  for (int scene = 0; scene < 40; ++scene) {
    Mesh mesh;
    for (int i = 0; i < 5; ++i) {
      const auto point = [&] { return glm::vec2(random.inRange(0, 8), random.inRange(0, 8)); };
      addFlat(mesh, point(), point(), point(), {random.inRange(0, 1), random.inRange(0, 1), random.inRange(0, 1)},
              camera, random.inRange(0, 3));
    }
    const AntialiasScene drawn(camera, mesh);
    const Image<glm::vec3> areas = drawn.draw(everywhere(squareRule(1, "grid", 16)), kNight);
    const Image<glm::vec3> samples = drawn.draw(everywhere(squareRule(64, "sheared")), kNight);
    // An edge passes through some 80 of 64 x 64 strata, each of which it puts off by 0.29 of itself at random, so each
    // edge by sqrt(80) 0.29 / 4096 = 6e-4; two or three of them meet in a pixel, and colours differ by less than 1.
    EXPECT_LT(rmse(areas, samples), 1.3e-3) << scene;
    EXPECT_LT(greatestDifference(areas, samples), 0.007) << scene;
  }
}

}  // namespace
}  // namespace ocelli::test
