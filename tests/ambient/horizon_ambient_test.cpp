#include "oc_core/ambient/horizon_ambient.h"

#include <gmock/gmock.h>

#include "oc_core/ambient/ambient_error.h"
#include "oc_core/ambient/three_frusta.h"
#include "oc_core/base/error.h"
#include "oc_core/render/rasterize_graph.h"
#include "tests/ambient/ambient_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;
using testing::Each;
using testing::FloatNear;

HorizonImage imageOf(const GraphCamera& camera, const Mesh& mesh) {
  return {camera, raycast(camera, mesh, RayScene(mesh)), mesh};
}

HorizonImage planeImageOf(const PinholeCamera& camera, const Mesh& mesh) {
  return imageOf(GraphCamera(camera), mesh);
}

/// Every pixel along many directions.
constexpr HorizonWalk kFine{.directions = 64, .steps = 200};

TEST(HorizonAmbient, findsAPlaneFullyLit) {
  for (const float steepness : {0.0f, 0.7f, 3.0f}) {
    const Mesh mesh = test::tiltedPlane(steepness);
    const HorizonLight light =
        ambientByHorizon(test::pointsOf(smallCamera(), mesh), planeImageOf(smallCamera(), mesh), {}, kFine);
    EXPECT_THAT(light.light, Each(FloatNear(1, 1e-5f))) << steepness;
    EXPECT_EQ(light.notHeld, 0u);
  }
}

TEST(HorizonAmbient, isThatOfTwoPlanesDerivedByHand) {
  const Mesh mesh = test::valley();
  const AmbientOptions options{.radius = 0.8};
  const std::vector<AmbientPoint> all = test::pointsOf(smallCamera(), mesh);
  std::vector<AmbientPoint> points;
  for (const AmbientPoint& point : all) {
    if (glm::length(glm::vec2(point.position)) < 0.25f) {  // all that hides its light is in the image
      points.push_back(point);
    }
  }
  ASSERT_GT(points.size(), 100u);
  const HorizonLight light = ambientByHorizon(points, planeImageOf(smallCamera(), mesh), options, kFine);
  for (size_t i = 0; i < points.size(); ++i) {
    const double distance = static_cast<double>(std::abs(points[i].position.x)) * std::numbers::sqrt2;
    // A pixel covers 0.033 units: the weight of what is hidden between two samples is that of the second, and within
    // a pixel of the edge the other plane begins at the next one.
    EXPECT_NEAR(static_cast<double>(light.light[i]), 1 - test::hiddenInValley(distance, 0.8), 0.06) << distance;
  }
}

TEST(HorizonAmbient, isThatOfAPitDerivedByHand) {
  const Mesh mesh = test::pit(0.5f, 0.4f);
  const PinholeCamera camera(View{}, 240, 160);
  std::vector<AmbientPoint> points;
  for (const AmbientPoint& point : test::pointsOf(camera, mesh)) {
    if (glm::length(glm::vec2(point.position)) < 0.02f && point.position.z < -0.1f) {
      points.push_back(point);
    }
  }
  ASSERT_FALSE(points.empty());
  const HorizonLight light =
      ambientByHorizon(points, planeImageOf(camera, mesh), {.radius = 10, .attenuates = false}, {64, 400});
  // The rim is found to within a pixel of 0.0125 units: 0.02 of the cone's share of the disc.
  EXPECT_THAT(light.light, Each(FloatNear(0.25f / (0.25f + 0.16f), 0.03f)));
}

TEST(HorizonAmbient, agreesWithEverySampleOfTheImage) {
  const Mesh mesh = test::boxBeforeWall();
  View view;
  view.eye = {2, 1, 9};
  const PinholeCamera camera(view, 90, 60);
  const AmbientOptions options{.radius = 0.9};
  std::vector<AmbientPoint> points = test::pointsOf(camera, mesh);
  const std::vector<GraphCamera> cameras{GraphCamera(camera), threeFrusta(camera, {0, 0, 0.4}, boundsOf(mesh))};
  ASSERT_EQ(cameras[1].frusta().size(), 3u);
  for (const GraphCamera& graph : cameras) {
    const HorizonImage image = imageOf(graph, mesh);
    const HorizonLight fast = ambientByHorizon(points, image, options, kFine);
    const HorizonLight slow = ambientByHorizonSlowly(points, image, options, 64);
    EXPECT_EQ(fast.notHeld, slow.notHeld);
    const AmbientError error = ambientError(fast.light, slow.light);
    // Directions are turned by pixel in one of them; few samples lie in a sector next to the point.
    EXPECT_LT(error.rmse, 0.02);
    EXPECT_LT(std::abs(error.signedMean), 0.01);
  }
}

TEST(HorizonAmbient, countsWhatTheImageDoesNotHold) {
  const Mesh mesh = test::wall(0);
  const HorizonImage image = planeImageOf(smallCamera(), mesh);
  std::vector<AmbientPoint> points(3);
  points[0].position = {0, 0, 20};  // behind the eye
  points[1].position = {50, 0, 0};  // beyond the border
  points[2].position = {0, 0, -1};  // hidden, and yet in the image
  for (AmbientPoint& point : points) {
    point.normal = {0, 0, 1};
  }
  const HorizonLight light = ambientByHorizon(points, image, {}, {});
  EXPECT_EQ(light.notHeld, 2u);
  EXPECT_EQ(light.light[0], 1);
  EXPECT_EQ(light.light[1], 1);
}

TEST(HorizonAmbient, isOneWithoutARadiusOrSamples) {
  const Mesh mesh = test::valley();
  const std::vector<AmbientPoint> points = test::pointsOf(smallCamera(), mesh);
  EXPECT_THAT(ambientByHorizon(points, planeImageOf(smallCamera(), mesh), {.radius = 0}).light, Each(1.0f));
  const HorizonImage empty(GraphCamera(smallCamera()), FragmentImage(90, 60), mesh);
  EXPECT_THAT(ambientByHorizon(points, empty, {}).light, Each(1.0f));
  EXPECT_THROW(ambientByHorizon(points, empty, {}, {.directions = 0}), InputError);
  EXPECT_THROW(ambientByHorizon(points, empty, {}, {.steps = 0}), InputError);
}

}  // namespace
}  // namespace ocelli
