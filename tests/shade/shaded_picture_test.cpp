#include "oc_core/shade/shaded_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/scene/scene.h"
#include "oc_core/shade/shade_comparison.h"
#include "oc_core/shade/shaded_on_device.h"
#include "tests/shade/cpu_caster.h"
#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

const glm::vec3 kRed(0.8f, 0.1f, 0.1f);
const glm::vec3 kGrey(0.5f);

/// Mirror 0 lies at z = 0 and looks along +z, where mirror 1 stands at z = 2 and turns rays up, to a red box at
/// (0, 2, 2).
struct TwoMirrors {
  ShadedScene scene;
  Progress none;

  TwoMirrors() {
    scene.mirrors.push_back(test::specularObject(test::wall(0, 0.2f)));
    Mesh turned = test::wall(0, 0.4f);
    paint(turned, kGrey);
    transform(turned, glm::rotate(glm::translate(glm::mat4(1), {0, 0, 2}), glm::radians(45.0f), {1, 0, 0}));
    scene.mirrors.push_back(test::specularObject(std::move(turned)));
    scene.mirrors[1].isCast = true;
    Mesh box = makeBox(glm::vec3(0.3f));
    paint(box, kRed);
    append(scene.cast, box, glm::translate(glm::mat4(1), {0, 2, 2}));
  }

  SenderProxies proxies(const std::string& way, const DepthRayCaster* caster = nullptr) const {
    SenderProxies made;
    for (const SpecularObject& mirror : scene.mirrors) {
      const CastObjects cast = castObjects(scene, &mirror);
      const Box box = boundsOf(mirror.mesh);
      const PinholeCamera reference(referenceView(*cast.mesh, box, 90, 60, WhatLiesAround::kMayBeLost), 90, 60);
      made.senders.push_back(
          buildProxy(specularWay(way), {scene, cast, box.center(), reference, {.sideRadii = 0.2f}, 32, none, caster}));
    }
    return made;
  }
  static SecondaryRays oneRay(const glm::vec3& origin = {0.01f, 0.02f, 0}, const glm::vec3& direction = {0, 0, 1}) {
    return {Image<glm::vec3>(1, 1), {{origin, direction, 0, 0}}};
  }
};

TEST(ShadedPicture, raysGoOnFromMirrorsUpToTheirOrder) {
  const TwoMirrors two;
  for (const char* way : {"traced", "di", "ddoc", "cell", "ldi-2", "di:stepped-1/4"}) {
    const SenderProxies proxies = two.proxies(way);
    const ShadedPicture first = shade(TwoMirrors::oneRay(), proxies, 1);
    EXPECT_LT(glm::distance(first.color(0, 0), kGrey), 1e-3f) << way << ": the mirror's own colour";
    EXPECT_TRUE(first.seconds.empty()) << way;
    for (const int order : {2, 3}) {
      const ShadedPicture second = shade(TwoMirrors::oneRay(), proxies, order);
      EXPECT_LT(glm::distance(second.color(0, 0), kRed), 1e-3f) << way;
      EXPECT_TRUE(second.hits[0].onCast) << way;
      EXPECT_NEAR(*second.hits[0].distance, 2.02f, 2e-3f) << way << ": of the first order still";
      ASSERT_TRUE(second.seconds[0]) << way;
      EXPECT_EQ(second.seconds[0]->mirror, 1u) << way;
      EXPECT_LT(glm::distance(second.seconds[0]->position, {0.01f, 1.7f, 2.02f}), 3e-3f) << way;
    }
  }
}

// Order by order on a device, rays see what they see one by one, and take as many steps.
TEST(ShadedPicture, aDeviceFollowsTheSameRays) {
  const TwoMirrors two;
  const test::CpuCaster caster;
  SecondaryRays rays{Image<glm::vec3>(16, 16, glm::vec3(0.25f)), {}};
  for (uint32_t pixel = 0; pixel < rays.base.size(); pixel += 3) {
    const float x = 0.05f * (static_cast<float>(pixel % 16) - 8);
    const float y = 0.05f * (static_cast<float>(pixel / 16) - 8);
    // Of the first mirror towards the second, and of that one up to the box.
    rays.rays.push_back(pixel % 2 == 0 ? SecondaryRay{{x, y, 0}, {0, 0, 1}, pixel, 0}
                                       : SecondaryRay{{x, 0, 2 + y}, {0, 1, 0}, pixel, 1});
  }
  for (const char* way : {"di", "ldi-2"}) {
    const SenderProxies proxies = two.proxies(way, &caster);
    for (const int order : {1, 2, 4}) {
      const std::optional<ShadedPicture> got = shadeOnDevice(rays, proxies, order, 2);
      const ShadedPicture expected = shade(rays, proxies, order);
      ASSERT_TRUE(got);
      EXPECT_TRUE(std::equal(expected.color.begin(), expected.color.end(), got->color.begin())) << way << " " << order;
      EXPECT_EQ(got->stepsOfRay, expected.stepsOfRay);
      EXPECT_EQ(got->cost.boxes, expected.cost.boxes);
      EXPECT_EQ(got->cost.triangles, expected.cost.triangles);
      EXPECT_EQ(differingRays(rays, *got, expected), 0u);
      ASSERT_EQ(got->seconds.size(), expected.seconds.size());
      size_t seconds = 0;
      for (size_t i = 0; i < expected.seconds.size(); ++i) {
        ASSERT_EQ(got->seconds[i].has_value(), expected.seconds[i].has_value());
        if (expected.seconds[i]) {
          ++seconds;
          EXPECT_EQ(got->seconds[i]->mirror, expected.seconds[i]->mirror);
          EXPECT_EQ(got->seconds[i]->position, expected.seconds[i]->position);
        }
      }
      EXPECT_EQ(seconds > 5, order > 1) << seconds;
    }
  }
  for (const char* way : {"traced", "environment", "di:stepped"}) {
    EXPECT_FALSE(shadeOnDevice(rays, two.proxies(way, &caster), 1)) << way;
  }
  EXPECT_FALSE(shadeOnDevice(rays, two.proxies("di"), 1)) << "without a device";
}

TEST(ShadedPicture, secondOrderHitsAreCompared) {
  const TwoMirrors two;
  const SenderProxies traced = two.proxies("traced");
  const ShadedPicture truth = shade(TwoMirrors::oneRay(), traced, 2);
  const Yardsticks yardsticks{{test::smallCamera(), test::smallCamera()}};
  ShadedPicture picture = truth;
  EXPECT_EQ(figuresOf(traced.total(), TwoMirrors::oneRay(), truth, picture, yardsticks).secondLost, 0u);
  EXPECT_EQ(figuresOf(traced.total(), TwoMirrors::oneRay(), truth, picture, yardsticks).secondRays, 1u);
  picture.seconds[0]->position.x += 1;
  EXPECT_EQ(figuresOf(traced.total(), TwoMirrors::oneRay(), truth, picture, yardsticks).secondLost, 1u);
  picture.seconds[0].reset();
  EXPECT_EQ(figuresOf(traced.total(), TwoMirrors::oneRay(), truth, picture, yardsticks).secondLost, 1u);
}

TEST(ShadedPicture, sizesAreOfAllSenders) {
  const SenderProxies proxies = TwoMirrors().proxies("di");
  EXPECT_EQ(proxies.total().samples, proxies.senders[0].samples + proxies.senders[1].samples);
  EXPECT_EQ(proxies.total().name, "di");
}

// A ray that is none sees nothing that has a distance, and ends.
TEST(ShadedPicture, degenerateRaysMeetNothing) {
  const TwoMirrors two;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const char* way : {"traced", "environment", "di", "di:stepped"}) {
    const SenderProxies proxies = two.proxies(way);
    for (const glm::vec3& direction : {glm::vec3(0), glm::vec3(kNan), glm::vec3(kInfinity, 0, 0)}) {
      const ShadedPicture picture = shade(TwoMirrors::oneRay({0, 0, 0}, direction), proxies, 3);
      EXPECT_FALSE(picture.hits[0].distance) << way;
      EXPECT_FALSE(picture.hits[0].onCast) << way;
    }
    EXPECT_FALSE(shade(TwoMirrors::oneRay(glm::vec3(kNan)), proxies, 3).hits[0].distance) << way;
  }
}

}  // namespace
}  // namespace ocelli
