#include "oc_core/soft_shadows/light_shadow_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/soft_shadows/light_scenes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

LightShadowMap mapOf(const Mesh& mesh, const AreaLight& light, int width = 60, int height = 40) {
  const PinholeCamera camera(lightView(light, mesh, width, height, "test"), width, height);
  return {buildDepthImage(camera, mesh), LightFrame(light)};
}

// Depths are distances from the plane of the light, and texels are where slopes say, also for lights that are turned.
TEST(LightShadowMap, holdsDepthsWhereSlopesSay) {
  for (const double turn : {0.0, 40.0, 180.0}) {
    const AreaLight light = areaLightTowards({1, 4, 0.5f}, {0.2f, 0, 0}, 1, 1, false, turn, "test");
    const LightFrame frame(light);
    Mesh mesh;
    append(mesh, makeBox({0.1f, 0.1f, 0.1f}), glm::translate(glm::mat4(1), {0.8f, 1, 0.2f}));
    append(mesh, makeBox({0.15f, 0.05f, 0.1f}), glm::translate(glm::mat4(1), {-0.5f, 0.3f, -0.4f}));
    const LightShadowMap map = mapOf(mesh, light);
    for (const glm::vec3 middle : {glm::vec3(0.8f, 1, 0.2f), glm::vec3(-0.5f, 0.3f, -0.4f)}) {
      const glm::vec3 p = frame.fromWorld(middle);
      const glm::vec2 texel = map.texel(glm::vec2(p) / p.z);
      const float depth = map.depth(static_cast<int>(texel.x), static_cast<int>(texel.y));
      EXPECT_LT(depth, p.z) << turn;
      EXPECT_GT(depth, p.z - 0.2f) << turn;  // the boxes reach 0.19 from their middles
      EXPECT_LT(glm::distance(map.slope(texel), glm::vec2(p) / p.z), 1e-5f);
    }
  }
}

TEST(LightShadowMap, knowsTheLeastDepths) {
  const LightShadowMap map = mapOf(test::randomBoxes(10, 1), test::lightAbove(), 37, 23);
  float least = LightShadowMap::kNothing;
  for (const float depth : map.leastDepths(0)) {
    least = std::min(least, depth);
  }
  EXPECT_EQ(map.leastDepth(), least);
  for (int level = 1; level < map.levels(); ++level) {
    const Image<float>& depths = map.leastDepths(level);
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        ASSERT_LE(depths(x >> level, y >> level), map.depth(x, y));
      }
    }
  }
}

TEST(LightView, holdsWhatCasts) {
  const Mesh mesh = test::randomBoxes(10, 2);
  const PinholeCamera camera(lightView(test::lightAbove(), mesh, 60, 40, "test"), 60, 40);
  for (const glm::vec3& p : mesh.positions) {
    const std::optional<ImagePoint> q = camera.project(p);
    ASSERT_TRUE(q);
    EXPECT_GE(q->u, 0);
    EXPECT_LE(q->u, 60);
    EXPECT_GE(q->v, 0);
    EXPECT_LE(q->v, 40);
  }
  EXPECT_THAT([] { lightView(test::lightAbove(), test::plate(-1, 1, -1, 1, 5), 60, 40, "test"); },
              ThrowsMessage<InputError>(HasSubstr("in front of the light")));
}

}  // namespace
}  // namespace ocelli
