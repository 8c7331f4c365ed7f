#include "oc_core/gl_rays/gl_ray_walk.h"

#include <gtest/gtest.h>

#include <limits>

#include "oc_core/gl/gl_api.h"
#include "tests/depth_rays/sampled_scenes.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

using test::smallCamera;

struct Cast {
  std::vector<std::optional<Hit>> hits;
  std::vector<RayCost> costs;
};

Cast onCpu(const DepthImageTarget& target, const std::vector<RayPath>& rays) {
  Cast cast{std::vector<std::optional<Hit>>(rays.size()), std::vector<RayCost>(rays.size())};
  for (size_t i = 0; i < rays.size(); ++i) {
    cast.hits[i] = target.hit(rays[i], cast.costs[i]);
  }
  return cast;
}

class GlRayWalkTest : public testing::TestWithParam<GlProvider> {
 protected:
  Cast onGpu(const DepthImageTarget& target, const std::vector<RayPath>& rays) {
    const GlScope scope(*context_);
    Cast cast{std::vector<std::optional<Hit>>(rays.size()), std::vector<RayCost>(rays.size())};
    castOnGpu(*context_, GlRayWalk(*context_, target), target, rays, cast.hits, cast.costs);
    return cast;
  }
  ~GlRayWalkTest() override { EXPECT_EQ(context_->liveObjects(), 0); }

  const std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlRayWalkTest, kOffscreenProviders, providerName);

bool agree(const std::optional<Hit>& a, const std::optional<Hit>& b) {
  // A hundred roundings at the distance of the scene, 10.
  constexpr float kNear = 1e-4f;
  return a.has_value() == b.has_value() &&
         (!a || (std::abs(a->t - b->t) <= kNear && glm::distance(a->color, b->color) <= 1.0f / 255));
}

// All kinds, over rays of all sorts: what cameras promise, at least 99.5 %.
TEST_P(GlRayWalkTest, hitsWhatTheCpuHits) {
  const Mesh mesh = test::thingsBeforeWall();
  test::forEachSampledScene(
      mesh, PinholeCamera({}, 60, 40), [&](const std::string& name, const ReferenceImages& images) {
        const DepthImageTarget target(images);
        Random random(5);
        std::vector<RayPath> rays(4000);
        std::generate(rays.begin(), rays.end(), [&] { return test::randomRay(random); });
        const Cast expected = onCpu(target, rays);
        const Cast got = onGpu(target, rays);
        size_t differing = 0;
        size_t otherElements = 0;
        size_t otherCosts = 0;
        size_t met = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
          met += expected.hits[i].has_value();
          differing += !agree(expected.hits[i], got.hits[i]);
          otherElements += expected.hits[i] && got.hits[i] && expected.hits[i]->element != got.hits[i]->element;
          otherCosts += expected.costs[i].steps() != got.costs[i].steps();
          EXPECT_LE(got.costs[i].steps(), target.maxSteps()) << name;
        }
        EXPECT_GT(met, 200u) << name;
        EXPECT_LE(differing, rays.size() / 200) << name;
        std::printf("%s: differing %zu elements %zu costs %zu of %zu met\n", name.c_str(), differing, otherElements,
                    otherCosts, met);
      });
}

}  // namespace
}  // namespace ocelli
