#include "oc_core/shade/scene_proxies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/shade/shade_comparison.h"
#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

/// The mirror's scene and its reference camera.
struct Proxies {
  ShadedScene scene = test::mirrorBeforeBox();
  Box senders = boundsOf(scene.mirrors);
  PinholeCamera reference{referenceView(scene.cast, senders, 120, 80), 120, 80};
  SecondaryRays rays = reflectedRays({scene, scene.mirrors}, test::smallCamera());

  BuiltProxy build(const std::string& name) const {
    const Progress none;
    const CastObjects cast = castObjects(scene, nullptr);
    return buildProxy(specularWay(name), {scene, cast, senders.center(), reference, {.sideRadii = 1}, 256, none});
  }
};

// The mirrored box stands where the box is, as seen from behind the mirror.
TEST(SceneProxies, tracedRaysMeetTheSceneItself) {
  const Proxies proxies;
  const BuiltProxy traced = proxies.build("traced");
  RayCost cost;
  const ProxyHit box = traced.proxy->hit({{0.25f, 0.2f, 0}, {0, 0, 1}, 0}, cost);
  EXPECT_TRUE(box.onCast);
  EXPECT_NEAR(*box.distance, 1.9f, 1e-5f);
  EXPECT_LT(glm::distance(box.color, {0.8f, 0.1f, 0.1f}), 1e-6f);
  const ProxyHit wall = traced.proxy->hit({{0.45f, 0.2f, 0}, {0, 0, 1}, 0}, cost);
  EXPECT_FALSE(wall.onCast);
  EXPECT_NEAR(*wall.distance, 12, 1e-4f);
  const ProxyHit sky = traced.proxy->hit({{0, 0, 0}, {0, 0, -1}, 0}, cost);
  EXPECT_FALSE(sky.distance);
  EXPECT_EQ(sky.color, shadeBackground());
  EXPECT_EQ(cost.steps(), 0u);
}

TEST(SceneProxies, depthImagesMeetTheBoxAndBillboardsWhereTheyAre) {
  const Proxies proxies;
  for (const char* name : {"di", "ddoc", "spoc", "cell", "ldi-2", "eoc-h"}) {
    const BuiltProxy built = proxies.build(name);
    EXPECT_GT(built.samples, 50u) << name;
    RayCost cost;
    const ProxyHit box = built.proxy->hit({{0.25f, 0.2f, 0}, {0, 0, 1}, 0}, cost);
    EXPECT_TRUE(box.onCast) << name;
    ASSERT_TRUE(box.distance) << name;
    EXPECT_NEAR(*box.distance, 1.9f, 2e-3f) << name;
    const ProxyHit wall = built.proxy->hit({{0.45f, 0.2f, 0}, {0, 0, 1}, 0}, cost);
    EXPECT_FALSE(wall.onCast) << name;
    EXPECT_NEAR(*wall.distance, 12, 1e-4f) << name;
  }
}

TEST(SceneProxies, anEnvironmentMapTellsNoDistance) {
  const Proxies proxies;
  const BuiltProxy built = proxies.build("environment");
  EXPECT_FALSE(built.hasDepth);
  RayCost cost;
  // It shows the box where it is from the mirror's middle.
  const ProxyHit box = built.proxy->hit({{9, 9, 9}, glm::normalize(glm::vec3(0.25f, 0.2f, 1.9f)), 0}, cost);
  EXPECT_LT(glm::distance(box.color, {0.8f, 0.1f, 0.1f}), 1e-6f);
  EXPECT_FALSE(box.distance);
}

// A box before a far wall: a depth image loses at most rays at its silhouette, and looks more like the truth than the
// environment map does.
TEST(SceneProxies, aDepthImageIsNearerToTheTruthThanAnEnvironmentMap) {
  const Proxies proxies;
  const BuiltProxy traced = proxies.build("traced");
  const ShadedPicture truth = shade(proxies.rays, *traced.proxy);
  const auto figures = [&](const std::string& name) {
    const BuiltProxy built = proxies.build(name);
    return figuresOf(built, proxies.rays, truth, shade(proxies.rays, *built.proxy), {{proxies.reference}});
  };
  const ShadeFigures self = figures("traced");
  EXPECT_EQ(self.lost, 0u);
  EXPECT_EQ(self.falseHits, 0u);
  EXPECT_TRUE(std::isinf(self.psnrDecibels));
  EXPECT_GT(self.castRays, 10u);
  const ShadeFigures di = figures("di");
  const ShadeFigures environment = figures("environment");
  EXPECT_LT(di.lostRatio(), 0.2);
  EXPECT_GT(di.psnrDecibels, environment.psnrDecibels + 3);
  EXPECT_GT(di.stepsPerRay(), 0);
}

TEST(SceneProxies, namesThatAreNoneAreErrors) {
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  EXPECT_THAT([] { checkProxyName("geometry"); }, ThrowsMessage<InputError>(HasSubstr("has no image for rays to hit")));
  EXPECT_THROW(checkProxyName("dii"), InputError);
  EXPECT_NO_THROW(checkProxyName("traced"));
  EXPECT_NO_THROW(checkProxyName("ldi-3"));
}

}  // namespace
}  // namespace ocelli
