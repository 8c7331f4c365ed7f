#include "oc_core/shade/ray_view.h"

#include <gtest/gtest.h>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/scene/scene.h"
#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

using test::smallCamera;

/// Rays that come from the surface of a ball as from one point in its middle.
std::vector<SecondaryRay> raysFrom(const glm::vec3& point, const glm::vec3& towards, float startsAt) {
  std::vector<SecondaryRay> rays;
  for (int i = 0; i < 40; ++i) {
    for (int k = 0; k < 40; ++k) {
      const glm::vec3 target =
          towards + glm::vec3(static_cast<float>(i) - 19.5f, static_cast<float>(k) - 19.5f, 0) * 0.01f;
      const glm::vec3 direction = glm::normalize(target - point);
      rays.push_back({point + direction * startsAt, direction});
    }
  }
  return rays;
}

// What a plane mirrors is seen as by the mirrored eye, through a window in the place of the mirror.
TEST(RayView, isTheMirroredEyeOfAPlane) {
  const ShadedScene scene = test::mirrorBeforeBox();
  const SecondaryRays rays = reflectedRays({scene, scene.mirrors}, smallCamera());
  const auto found = viewOfRays(rays.rays, scene.cast, {0, 0, 0}, 120, 80);
  ASSERT_TRUE(found);
  EXPECT_LT(glm::distance(found->view.eye, {0, 0, -10}), 0.05f)
      << "rays an angle of one degree apart, of single precision, over ten units";
  // All rays pass one point: the cell is as small as it may be, a hundredth of the distance to the box.
  EXPECT_NEAR(found->cellSide, 0.119f, 0.002f);
  const PinholeCamera camera(found->view, 120, 80);
  for (const glm::vec3& corner : scene.cast.positions) {
    const auto image = camera.project(corner);
    ASSERT_TRUE(image);
    EXPECT_TRUE(image->u > 0 && image->u < 120 && image->v > 0 && image->v < 80);
  }
  EXPECT_GT(found->view.zNear, 10) << "what stands behind the mirror hides nothing";
  EXPECT_LT(found->view.zNear, 11.9f);
}

TEST(RayView, isAsWideAsWhatTheRaysMayMeet) {
  Mesh things = makeSphere(32);
  transform(things, glm::scale(glm::translate(glm::mat4(1), {0, 0, 4}), glm::vec3(0.3f)));
  Mesh aside = makeSphere(32);
  transform(aside, glm::scale(glm::translate(glm::mat4(1), {3, 0, 4}), glm::vec3(0.3f)));
  append(things, aside);
  const auto found = viewOfRays(raysFrom({0, 0, 1}, {0, 0, 4}, 0.5f), things, {0, 0, 0}, 90, 90);
  ASSERT_TRUE(found);
  EXPECT_LT(glm::distance(found->view.eye, {0, 0, 1}), 1e-3f);
  // A ball of radius 0.3 at 3 units, of which the rays meet 0.2 at most to the sides, within cells of 1/48 of the box.
  EXPECT_GT(found->view.fovVerticalDegrees, 2 * degreesFromRadians(std::atan(0.19 / 3)));
  EXPECT_LT(found->view.fovVerticalDegrees, 2 * degreesFromRadians(std::atan(0.3 / 2.5)));
}

// The rays meet in the midst of what they meet: the eye comes back from there until all lies before it.
TEST(RayView, looksFromBeforeAFocus) {
  Mesh things = makeSphere(16);
  transform(things, glm::scale(glm::translate(glm::mat4(1), {0.05f, 0, 1.5f}), glm::vec3(0.2f)));
  Mesh behind = makeSphere(16);
  transform(behind, glm::scale(glm::translate(glm::mat4(1), {0.05f, 0, 3}), glm::vec3(0.2f)));
  append(things, behind);
  std::vector<SecondaryRay> rays;
  for (const SecondaryRay& ray : raysFrom({0, 0, 2}, {0, 0, 3}, 0)) {
    rays.push_back({ray.origin - ray.direction * 2.0f, ray.direction});
  }
  const auto found = viewOfRays(rays, things, {0, 0, 0}, 90, 90);
  ASSERT_TRUE(found);
  EXPECT_LT(found->view.eye.z, 1.3f);
  EXPECT_GT(found->view.eye.z, 0);
  EXPECT_GT(found->cellSide, 0.05f) << "they spread there";
}

TEST(RayView, givesUpWhereThereIsNone) {
  Mesh things = makeSphere(16);
  EXPECT_FALSE(viewOfRays({}, things, {0, 0, 0}, 90, 60));
  EXPECT_FALSE(viewOfRays(raysFrom({0, 0, 3}, {0, 0, 9}, 0), things, {0, 0, 3}, 90, 60)) << "they meet nothing";
  EXPECT_FALSE(viewOfRays(raysFrom({0, 0, 3}, {0, 0, 0}, 0), {}, {0, 0, 3}, 90, 60));
  std::vector<SecondaryRay> parallel;
  std::vector<SecondaryRay> broken;
  for (int i = 0; i < 1000; ++i) {
    parallel.push_back({{0.001f * static_cast<float>(i) - 0.5f, 0.1f, 3}, {0, 0, -1}});
    broken.push_back({glm::vec3(std::numeric_limits<float>::quiet_NaN()), {0, 0, -1}});
  }
  EXPECT_FALSE(viewOfRays(parallel, things, {0, 0, 3}, 90, 60));
  EXPECT_FALSE(viewOfRays(broken, things, {0, 0, 3}, 90, 60));
  // From its midst to all sides: no plane holds that.
  std::vector<SecondaryRay> around;
  for (const glm::vec3& vertex : things.positions) {
    for (int i = 0; i < 8; ++i) {
      around.push_back({{0, 0, 0}, glm::normalize(vertex)});
    }
  }
  EXPECT_FALSE(viewOfRays(around, things, {0, 0, 0}, 90, 60));
}

}  // namespace
}  // namespace ocelli
