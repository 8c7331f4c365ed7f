#include "oc_core/ambient/ray_ambient.h"

#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "tests/ambient/ambient_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;
using testing::Each;

TEST(RayAmbient, findsAPlaneFullyLit) {
  const Mesh mesh = test::tiltedPlane(0.7f);
  const RayScene scene(mesh);
  EXPECT_THAT(ambientByRays(test::pointsOf(smallCamera(), mesh), scene, {}, {}), Each(1.0f));
}

TEST(RayAmbient, isThatOfTwoPlanesDerivedByHand) {
  const Mesh mesh = test::valley();
  const RayScene scene(mesh);
  const AmbientOptions options{.radius = 0.8};
  const std::vector<AmbientPoint> points = test::pointsOf(smallCamera(), mesh);
  const std::vector<float> light = ambientByRays(points, scene, options, {.count = 256});
  double error = 0;
  double mean = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const double distance = static_cast<double>(std::abs(points[i].position.x)) * std::numbers::sqrt2;
    const double off = static_cast<double>(light[i]) - (1 - test::hiddenInValley(distance, 0.8));
    error = std::max(error, std::abs(off));
    mean += off / static_cast<double>(points.size());
  }
  // The discrepancy of 256 points of a Hammersley set from a region of the disc is about log(256) / 256.
  EXPECT_LT(error, 0.022);
  EXPECT_LT(std::abs(mean), 2e-4) << "over many pixels, each with a shift of its own, it has no bias";
}

TEST(RayAmbient, isThatOfAPitDerivedByHand) {
  const Mesh mesh = test::pit(0.5f, 0.4f);
  const RayScene scene(mesh);
  AmbientPoint middle;
  middle.position = {0, 0, -0.4f};
  middle.normal = {0, 0, 1};
  const std::vector<AmbientPoint> points(64, middle);
  const std::vector<float> light = ambientByRays(points, scene, {.radius = 10, .attenuates = false}, {.count = 1024});
  // The sky is seen within a cone: a disc of radius sin of the half angle below the hemisphere.
  EXPECT_THAT(light, Each(testing::FloatNear(0.25f / (0.25f + 0.16f), 0.01f)));
}

TEST(RayAmbient, directionsWeighByTheirCosine) {
  constexpr int kCount = 1024;
  double cosines = 0;
  glm::dvec3 sum(0);
  for (int i = 0; i < kCount; ++i) {
    const glm::vec3 direction = hemisphereDirection(i, kCount, {0.3f, 0.8f});
    EXPECT_NEAR(glm::length(direction), 1, 1e-6);
    EXPECT_GE(direction.z, 0);
    sum += glm::dvec3(direction);
    cosines += static_cast<double>(direction.z);
  }
  EXPECT_NEAR(cosines / kCount, 2.0 / 3, 1e-3) << "the mean cosine of a cosine-weighted hemisphere";
  EXPECT_NEAR(sum.x / kCount, 0, 3e-3);
  EXPECT_NEAR(sum.y / kCount, 0, 3e-3);
}

TEST(RayAmbient, isOneWithoutARadiusAndWithoutAScene) {
  const Mesh mesh = test::valley();
  const RayScene scene(mesh);
  const std::vector<AmbientPoint> points = test::pointsOf(smallCamera(), mesh);
  EXPECT_THAT(ambientByRays(points, scene, {.radius = 0}, {}), Each(1.0f));
  const Mesh nothing;
  EXPECT_THAT(ambientByRays(points, RayScene(nothing), {}, {.count = 4}), Each(1.0f));
  EXPECT_TRUE(ambientByRays({}, scene, {}, {}).empty());
}

TEST(RayAmbient, refusesNumbersOfRaysThatItCannotCast) {
  const Mesh mesh = test::wall(0);
  const RayScene scene(mesh);
  EXPECT_THROW(ambientByRays({}, scene, {}, {.count = 0}), InputError);
  EXPECT_THROW(ambientByRays({}, scene, {}, {.count = 5000}), InputError);
  EXPECT_THROW(ambientByRays({}, scene, {.radius = -1}, {}), InputError);
}

}  // namespace
}  // namespace ocelli
