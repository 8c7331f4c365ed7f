// Known directions of the panoramas; what all cameras have in common is in camera_contract_test.cpp.
#include "oc_core/camera/panorama_camera.h"

#include <gtest/gtest.h>

#include "oc_core/camera/cylinder_camera.h"

namespace ocelli {
namespace {

/// At the origin, looking along -z, with x to the right and y up.
View viewAtOrigin() {
  View view;
  view.eye = {0, 0, 0};
  view.target = {0, 0, -1};
  view.fovVerticalDegrees = 90;
  return view;
}

void expectImage(const std::optional<ImagePoint>& q, float u, float v, float z) {
  ASSERT_TRUE(q);
  EXPECT_NEAR(q->u, u, 1e-4);
  EXPECT_NEAR(q->v, v, 1e-4);
  EXPECT_NEAR(q->t, z, 1e-5);
}

TEST(PanoramaCamera, directionsAreLongitudesAndLatitudes) {
  const PanoramaCamera camera(PinholeCamera(viewAtOrigin(), 360, 180));  // a degree a pixel
  expectImage(camera.project({0, 0, -5}), 180, 90, 5);                   // ahead
  expectImage(camera.project({2, 0, 0}), 270, 90, 2);                    // to the right
  expectImage(camera.project({-2, 0, 0}), 90, 90, 2);                    // to the left
  expectImage(camera.project({1, 0, -1}), 225, 90, std::sqrt(2.0f));
  expectImage(camera.project({0, 1, -1}), 180, 45, std::sqrt(2.0f));  // above
  expectImage(camera.project({0, -1, 1e-6f}), 360, 180, 1);           // below, and hardly behind
  EXPECT_EQ(camera.project({0, 3, 0})->v, 0);
}

// To both sides of what is behind, the image ends and begins.
TEST(PanoramaCamera, goesOnAtTheOtherBorder) {
  const PanoramaCamera camera(PinholeCamera(viewAtOrigin(), 360, 180));
  expectImage(camera.project({0.01f, 0, 1}), 360 - 0.57294f, 90, 1.00005f);
  expectImage(camera.project({-0.01f, 0, 1}), 0.57294f, 90, 1.00005f);
}

TEST(CylinderCamera, rowsAreThoseOfAPlane) {
  // 90 degrees over 100 rows: a focal length of 50.
  const CylinderCamera camera(PinholeCamera(viewAtOrigin(), 400, 100));
  expectImage(camera.project({0, 0, -4}), 200, 50, 4);
  expectImage(camera.project({0, 2, -4}), 200, 25, std::sqrt(20.0f));
  expectImage(camera.project({4, 2, 0}), 300, 25, std::sqrt(20.0f));  // the same height to the right
  expectImage(camera.project({0, -4, -4}), 200, 100, std::sqrt(32.0f));
  EXPECT_FALSE(camera.project({0, 1, 0})) << "on the axis";
}

}  // namespace
}  // namespace ocelli
