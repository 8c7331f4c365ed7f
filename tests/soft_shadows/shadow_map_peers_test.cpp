// Percentage-closer soft shadows and back-projection, where they are known to be right, and where they are not.
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/soft_shadows/light_backprojection.h"
#include "oc_core/soft_shadows/percentage_closer.h"
#include "tests/soft_shadows/light_scenes.h"

namespace ocelli {
namespace {

constexpr int kWidth = 360;
constexpr int kHeight = 240;

LightShadowMap sharpMap(const Mesh& mesh, const AreaLight& light) {
  const PinholeCamera camera(lightView(light, mesh, kWidth, kHeight, "test"), kWidth, kHeight);
  return {buildDepthImage(camera, mesh), LightFrame(light)};
}

float backprojected(const Mesh& mesh, const AreaLight& light, const ShadowReceiver& receiver) {
  return BackprojectedShadows(sharpMap(mesh, light), light).of(std::vector<ShadowReceiver>{receiver}).share[0];
}

float percentageCloser(const Mesh& mesh, const AreaLight& light, const ShadowReceiver& receiver) {
  return PercentageCloserShadows(sharpMap(mesh, light), light, {.searchTaps = 24, .filterTaps = 32})
      .of(std::vector<ShadowReceiver>{receiver})
      .share[0];
}

// One plate that is parallel to the light: both know all there is to know. The map's texels are 4 / 240 units or so at
// the plate, 1 / 60 of the light's height as seen from the floor, twice that as projected.
TEST(ShadowMapPeers, areRightUnderOnePlate) {
  const Mesh mesh = test::plate(-1, 0.2f, -0.8f, 0.8f, 2);
  const AreaLight light = test::lightAbove();
  for (const float x : {-0.5f, 0.0f, 0.4f, 0.8f, 1.2f, 1.6f}) {
    const float exact = std::clamp((x + 0.6f) / 2, 0.0f, 1.0f);  // free is what lies beyond 0.4 - x
    EXPECT_NEAR(backprojected(mesh, light, test::onFloor(x, 0)), exact, 0.04f) << x;
    // Taps by chance: 4 sigma of 32 rows.
    EXPECT_NEAR(percentageCloser(mesh, light, test::onFloor(x, 0)), exact, 0.06f) << x;
  }
}

// The gaps between texels are filled: below the middle of a plate no light leaks, also where it leans.
TEST(ShadowMapPeers, backprojectionFillsGaps) {
  Mesh mesh;
  append(mesh, test::plate(-1.2f, 1.2f, -1.2f, 1.2f, 0),
         glm::rotate(glm::translate(glm::mat4(1), {0, 2.2f, 0}), 0.5f, glm::vec3(0, 0, 1)));
  for (const float x : {-0.3f, 0.0f, 0.25f}) {
    EXPECT_EQ(backprojected(mesh, test::lightAbove(false, 0.8f, 0.8f), test::onFloor(x, 0)), 0) << x;
  }
}

// Without an occluder, in a map that shows something elsewhere.
TEST(ShadowMapPeers, seeAllBesideOccluders) {
  const Mesh mesh = test::plate(-0.1f, 0.1f, -0.1f, 0.1f, 2);
  EXPECT_EQ(backprojected(mesh, test::lightAbove(), test::onFloor(3, 0)), 1);
  EXPECT_EQ(percentageCloser(mesh, test::lightAbove(), test::onFloor(3, 0)), 1);
  EXPECT_EQ(backprojected(mesh, test::lightAbove(), {{0, 3, 0}, {0, 1, 0}}), 1) << "above the plate";
  EXPECT_EQ(percentageCloser(mesh, test::lightAbove(), {{0, 3, 0}, {0, 1, 0}}), 1);
}

// Two plates at different depths: the mean of their depths is that of neither, so that percentage-closer soft shadows
// are wrong where the masks of back-projection are right.
TEST(ShadowMapPeers, percentageCloserFailsWherePenumbraeOverlap) {
  Mesh mesh = test::plate(-2, 0, -2, 2, 3);
  append(mesh, test::plate(0.45f, 2, -2, 2, 1));
  const AreaLight light = test::lightAbove();
  // From (x, 0): the upper plate hides x' < -3 x, the lower one x' > 0.6 - x / 3.
  const float x = 0.2f;
  const float exact = (0.6f - x / 3 + 3 * x) / 2;
  EXPECT_NEAR(backprojected(mesh, light, test::onFloor(x, 0)), exact, 0.05f);
  EXPECT_GT(std::abs(percentageCloser(mesh, light, test::onFloor(x, 0)) - exact), 0.15f);
}

// Maps of one texel, and of nothing.
TEST(ShadowMapPeers, takeTinyMaps) {
  const Mesh mesh = test::plate(-1, 1, -1, 1, 2);
  const AreaLight light = test::lightAbove();
  const PinholeCamera camera(lightView(light, mesh, 1, 1, "test"), 1, 1);
  const LightShadowMap one(buildDepthImage(camera, mesh), LightFrame(light));
  const LightShadowMap none(blankReferenceImage("di", camera.view(), 1, 1), LightFrame(light));
  const std::vector<ShadowReceiver> receivers{test::onFloor(0, 0), test::onFloor(9, 0)};
  EXPECT_EQ(BackprojectedShadows(one, light).of(receivers).share, (std::vector<float>{0, 1}));
  EXPECT_EQ(BackprojectedShadows(none, light).of(receivers).share, (std::vector<float>{1, 1}));
  EXPECT_EQ(PercentageCloserShadows(one, light).of(receivers).share, (std::vector<float>{0, 1}));
  EXPECT_EQ(PercentageCloserShadows(none, light).of(receivers).share, (std::vector<float>{1, 1}));
}

}  // namespace
}  // namespace ocelli
