#include "oc_core/ambient/ambient_points.h"

#include <gmock/gmock.h>

#include "oc_core/ambient/ambient_options.h"
#include "oc_core/base/error.h"
#include "tests/ambient/ambient_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

TEST(AmbientPoints, areWhatPixelsShow) {
  const PinholeCamera camera = smallCamera();
  const Mesh mesh = test::wall(-2, 0.5f);
  const std::vector<AmbientPoint> points = test::pointsOf(camera, mesh);
  ASSERT_FALSE(points.empty());
  EXPECT_LT(points.size(), static_cast<size_t>(camera.width() * camera.height())) << "the wall fills no image";
  for (const AmbientPoint& point : points) {
    EXPECT_NEAR(point.position.z, -2, 1e-5);
    EXPECT_EQ(point.normal, glm::vec3(0, 0, 1));
    EXPECT_NEAR(point.footprint, 12 / camera.focalPixels(), 1e-5);
    const auto place = camera.project(point.position);
    ASSERT_TRUE(place);
    EXPECT_EQ(static_cast<uint32_t>(place->v) * 90 + static_cast<uint32_t>(place->u), point.pixel);
  }
}

TEST(AmbientPoints, turnNormalsTowardsTheEye) {
  Mesh mesh = test::wall(0);
  for (glm::uvec3& triangle : mesh.triangles) {
    std::swap(triangle.x, triangle.y);
  }
  for (const AmbientPoint& point : test::pointsOf(smallCamera(), mesh)) {
    EXPECT_EQ(point.normal, glm::vec3(0, 0, 1));
  }
}

TEST(AmbientPoints, areOfWhatReceives) {
  const Mesh mesh = test::boxBeforeWall();
  const FragmentImage seen = raycast(smallCamera(), mesh, RayScene(mesh));
  const auto isWall = [](uint32_t triangle) { return triangle < 2; };
  const std::vector<AmbientPoint> onWall = ambientPoints(smallCamera(), seen, mesh, isWall);
  EXPECT_FALSE(onWall.empty());
  EXPECT_LT(onWall.size(), ambientPoints(smallCamera(), seen, mesh).size());
  for (const AmbientPoint& point : onWall) {
    EXPECT_TRUE(isWall(point.triangle));
  }
}

TEST(AmbientPoints, areNoneWhereNothingIsSeen) {
  EXPECT_TRUE(ambientPoints(smallCamera(), FragmentImage(90, 60), test::wall(0)).empty());
  // What has no area has no normal.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  FragmentImage seen(90, 60);
  seen(3, 4) = {10, 0, 0.5f, 0};
  EXPECT_TRUE(ambientPoints(smallCamera(), seen, mesh).empty());
}

TEST(AmbientOptions, weighByDistance) {
  const AmbientOptions soft{.radius = 2};
  EXPECT_EQ(soft.weight(0), 1);
  EXPECT_EQ(soft.weight(1), 0.75);
  EXPECT_EQ(soft.weight(2), 0);
  EXPECT_EQ(soft.weight(3), 0);
  const AmbientOptions hard{.radius = 2, .attenuates = false};
  EXPECT_EQ(hard.weight(1.99), 1);
  EXPECT_EQ(hard.weight(2), 0);
  EXPECT_EQ(AmbientOptions{.radius = 0}.weight(0), 0);
  EXPECT_THROW(validate({.radius = -1}), InputError);
  EXPECT_THROW(validate({.radius = std::nan("")}), InputError);
}

}  // namespace
}  // namespace ocelli
