// Reflected and refracted rays of the scenes of `ocelli shade`, cast at reference images with OpenGL.
#include "oc_core/gl_rays/gl_ray_caster.h"

#include <gtest/gtest.h>

#include "oc_core/shade/scene_proxies.h"
#include "oc_core/shade/shade_comparison.h"
#include "oc_core/shade/shaded_on_device.h"
#include "tests/gl/gl_test_context.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

class GlRayCasterTest : public testing::TestWithParam<GlProvider> {
 protected:
  /// Rays see on the GPU what they see on the CPU, but for as many as 0.5 % of those that hit the images.
  void expectAgreement(const ShadedScene& scene, const SpecularObject& sender, const SecondaryRays& rays,
                       const std::string& name) const {
    const Progress none;
    const Box box = boundsOf(sender.mesh);
    const CastObjects cast = castObjects(scene, &sender);
    const PinholeCamera reference(referenceView(*cast.mesh, box, 180, 120), 180, 120);
    SenderProxies proxies;
    proxies.senders.push_back(
        buildProxy(specularWay(name), {scene, cast, box.center(), reference, {.sideRadii = 1}, 64, none, &caster_}));
    const std::optional<ShadedPicture> gpu = shadeOnDevice(rays, proxies, 1);
    const ShadedPicture cpu = shade(rays, proxies, 1);
    ASSERT_TRUE(gpu);
    size_t met = 0;
    for (const ProxyHit& hit : cpu.hits) {
      met += hit.onCast;
    }
    EXPECT_GT(met, 200u) << name;
    const size_t differing = differingRays(rays, *gpu, cpu);
    EXPECT_LE(differing, met / 200) << name;
    testing::Test::RecordProperty(name, std::to_string(differing));
    EXPECT_NEAR(static_cast<double>(gpu->cost.steps()), static_cast<double>(cpu.cost.steps()),
                0.01 * static_cast<double>(cpu.cost.steps()))
        << name;
  }

  const GlRayCaster caster_{openTestContext(GetParam())};
};
INSTANTIATE_TEST_SUITE_P(Providers, GlRayCasterTest, kOffscreenProviders, providerName);

constexpr std::array kWays{"di", "spoc", "ddoc", "cell", "ldi-4", "eoc-hv", "di+spoc", "corners-4"};

TEST_P(GlRayCasterTest, reflectedRaysSeeWhatTheySeeOnTheCpu) {
  const ShadedScene scene = loadShadedScene("builtin:mirror", rolesFor("builtin:mirror", ""));
  const PinholeCamera camera(pictureView(boundsOf(scene.mirrors)), 180, 120);
  const SecondaryRays rays = reflectedRays(FirstSurfaces(scene, scene.mirrors), camera);
  for (const char* name : kWays) {
    expectAgreement(scene, scene.mirrors[0], rays, name);
  }
}

TEST_P(GlRayCasterTest, refractedRaysSeeWhatTheySeeOnTheCpu) {
  const ShadedScene scene = loadShadedScene("builtin:lens", rolesFor("builtin:lens", ""));
  const PinholeCamera camera(pictureView(boundsOf(scene.lenses)), 180, 120);
  const SecondaryRays rays = refractedRays(FirstSurfaces(scene, scene.lenses), camera);
  for (const char* name : kWays) {
    expectAgreement(scene, scene.lenses[0], rays, name);
  }
}

// What a caster has prepared holds the context that it needs.
TEST_P(GlRayCasterTest, targetsOutliveTheCaster) {
  const DepthImageTarget image({buildDepthImage(PinholeCamera({}, 60, 40), test::wall(0, 1))});
  const DepthImageTarget empty({});
  auto caster = std::make_unique<GlRayCaster>(openTestContext(GetParam()));
  const auto first = caster->prepare(image);
  const auto second = caster->prepare(empty);
  caster.reset();
  const std::vector<RayPath> rays{{{0, 0, 5}, {0, 0, -5}}, {{3, 0, 5}, {3, 0, -5}}};
  std::vector<std::optional<Hit>> found(2);
  std::vector<RayCost> costs(2);
  second->hits(rays, found, costs);
  EXPECT_FALSE(found[0] || found[1]);
  first->hits(rays, found, costs);
  ASSERT_TRUE(found[0]);
  EXPECT_EQ(found[0]->element, image.hit(rays[0])->element);
  EXPECT_FALSE(found[1]);
  EXPECT_GT(costs[0].steps(), 0u);
}

// A window's context is its own, and others may draw with it before and after.
TEST_P(GlRayCasterTest, castsInAContextOfOthers) {
  const auto context = openTestContext(GetParam());
  const DepthImageTarget image({buildDepthImage(PinholeCamera({}, 60, 40), test::wall(0, 1))});
  const std::vector<RayPath> rays{{{0, 0, 5}, {0, 0, -5}}};
  std::vector<std::optional<Hit>> found(1);
  std::vector<RayCost> costs(1);
  const GlScope scope(*context);
  GlRayCaster(*context).prepare(image)->hits(rays, found, costs);
  EXPECT_TRUE(found[0]);
  EXPECT_EQ(context->liveObjects(), 0);
  context->check("drawing on");
}

}  // namespace
}  // namespace ocelli
