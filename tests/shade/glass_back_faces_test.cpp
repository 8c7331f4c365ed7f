#include "oc_core/shade/glass_back_faces.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

constexpr std::array kExits{BackFaceExit::kExpected, BackFaceExit::kSearched};

ShadedScene ballOfGlass(double index) {
  ShadedScene scene;
  scene.lenses.push_back(test::specularObject(makeSphere(128), index));
  return scene;
}

PinholeCamera finerCamera() {
  return {test::smallCamera().view(), 180, 120};
}

TEST(GlassBackFaces, giveTheSamePixelsARay) {
  const ShadedScene scene = ballOfGlass(1.5);
  const FirstSurfaces surfaces(scene, scene.lenses);
  const SecondaryRays traced = refractedRays(surfaces, finerCamera());
  for (const BackFaceExit exit : kExits) {
    const SecondaryRays rays = refractedRaysByBackFaces(surfaces, finerCamera(), exit);
    ASSERT_EQ(rays.rays.size(), traced.rays.size());
    for (size_t i = 0; i < rays.rays.size(); ++i) {
      ASSERT_EQ(rays.rays[i].pixel, traced.rays[i].pixel);
      ASSERT_NEAR(glm::length(rays.rays[i].direction), 1, 1e-5f);
    }
  }
}

TEST(GlassBackFaces, lightPassesGlassOfNoOpticalDensityStraight) {
  const ShadedScene scene = ballOfGlass(1);
  const FirstSurfaces surfaces(scene, scene.lenses);
  for (const BackFaceExit exit : kExits) {
    for (const SecondaryRay& ray : refractedRaysByBackFaces(surfaces, finerCamera(), exit).rays) {
      const glm::vec3 incoming = glm::normalize(ray.origin - glm::vec3(0, 0, 10));
      ASSERT_LT(glm::distance(ray.direction, incoming), 2e-3f);
    }
  }
}

// All of a ball's back faces are in the image, so that a search finds where rays leave, but for what lies between
// pixels; the expected way is one third too short for rays at the rim (a chord of 2 r cos(t), of which view and normal
// say 2 r cos(i) and 2 r).
TEST(GlassBackFaces, aSearchIsNearerToTheTracedRayThanWhatIsExpected) {
  const ShadedScene scene = ballOfGlass(1.5);
  const FirstSurfaces surfaces(scene, scene.lenses);
  const SecondaryRays traced = refractedRays(surfaces, finerCamera());
  const double searched =
      meanDegreesBetween(refractedRaysByBackFaces(surfaces, finerCamera(), BackFaceExit::kSearched), traced);
  const double expected =
      meanDegreesBetween(refractedRaysByBackFaces(surfaces, finerCamera(), BackFaceExit::kExpected), traced);
  EXPECT_LT(searched, 1);
  EXPECT_GT(expected, 3 * searched);
  EXPECT_LT(expected, 20);
  EXPECT_EQ(meanDegreesBetween(traced, traced), 0);
}

// At the middle all ways are the diameter.
TEST(GlassBackFaces, areExactAtTheMiddle) {
  const ShadedScene scene = ballOfGlass(1.5);
  const FirstSurfaces surfaces(scene, scene.lenses);
  View view = test::smallCamera().view();
  view.fovVerticalDegrees = 0.2;  // of 11.5 that the ball covers
  const PinholeCamera camera(view, 30, 20);
  const SecondaryRays traced = refractedRays(surfaces, camera);
  for (const BackFaceExit exit : kExits) {
    const SecondaryRays rays = refractedRaysByBackFaces(surfaces, camera, exit);
    EXPECT_LT(meanDegreesBetween(rays, traced), 0.2);
    EXPECT_NEAR(rays.rays[rays.rays.size() / 2].origin.z, -1, 0.01f);
  }
}

TEST(GlassBackFaces, anOpenObjectEndsRaysSomewhere) {
  ShadedScene scene;
  scene.lenses.push_back(test::specularObject(test::wall(0, 0.5f)));
  for (const BackFaceExit exit : kExits) {
    const SecondaryRays rays = refractedRaysByBackFaces({scene, scene.lenses}, test::smallCamera(), exit);
    EXPECT_GT(rays.rays.size(), 500u);
    for (const SecondaryRay& ray : rays.rays) {
      ASSERT_NEAR(glm::length(ray.direction), 1, 1e-5f);
      ASSERT_LT(ray.direction.z, -0.9f);
    }
  }
}

}  // namespace
}  // namespace ocelli
