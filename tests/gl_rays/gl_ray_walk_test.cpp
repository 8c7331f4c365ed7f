#include "oc_core/gl_rays/gl_ray_walk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/parallel.h"
#include "oc_core/gl/gl_api.h"
#include "tests/depth_rays/sampled_scenes.h"
#include "tests/gl/gl_test_context.h"
#include "tests/gl_rays/cast_agreement.h"

namespace ocelli {
namespace {

using test::CastHits;
using test::smallCamera;

DepthImageTarget depthImageOf(const Mesh& mesh) {
  return DepthImageTarget({buildDepthImage(smallCamera(), mesh)});
}

class GlRayWalkTest : public testing::TestWithParam<GlProvider> {
 protected:
  ~GlRayWalkTest() override { EXPECT_EQ(context_->liveObjects(), 0); }

  CastHits onGpu(const DepthImageTarget& target, const std::vector<RayPath>& rays) {
    const GlScope scope(*context_);
    CastHits cast(rays.size());
    castOnGpu(*context_, GlRayWalk(*context_, target), target, rays, cast.hits, cast.costs);
    return cast;
  }
  /// Distances of hits, 0 where there are none; without the CPU's help.
  std::vector<float> distances(const GlRayWalk& walk, const std::vector<StraightRay>& rays) {
    const Image<StraightRay> image = rayImage(rays);
    const FragmentImage fragments = walk.walk(GlRays(*context_, image)).fragments.read();
    std::vector<float> found;
    for (size_t i = 0; i < rays.size(); ++i) {
      found.push_back(fragments[rayTexel(image, i)].t);
    }
    return found;
  }

  const std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlRayWalkTest, kOffscreenProviders, providerName);

// All kinds, over rays of all sorts: what cameras promise, at least 99.5 %, here of the rays that hit something.
TEST_P(GlRayWalkTest, hitsWhatTheCpuHits) {
  const Mesh mesh = test::thingsBeforeWall();
  test::forEachSampledScene(mesh, PinholeCamera({}, 60, 40),
                            [&](const std::string& name, const ReferenceImages& images) {
                              const DepthImageTarget target(images);
                              Random random(5);
                              std::vector<RayPath> rays(4000);
                              std::generate(rays.begin(), rays.end(), [&] { return test::randomRay(random); });
                              const CastHits expected = test::castOnCpu(target, rays);
                              const CastHits got = onGpu(target, rays);
                              EXPECT_GT(test::metCount(expected), 200u) << name;
                              const size_t differing = test::differingHits(expected, got);
                              EXPECT_LE(differing, test::metCount(expected) / 200) << name;
                              testing::Test::RecordProperty(name, std::to_string(differing));
                              for (const RayCost& cost : got.costs) {
                                ASSERT_LE(cost.steps(), target.maxSteps()) << name;
                                ASSERT_LE(cost.boxes, SamplePyramid::kChildren * cost.nodes) << name;
                              }
                            });
}

// The order of the walk is that of the CPU, but for boxes that are entered at the same place.
TEST_P(GlRayWalkTest, takesAsManyStepsAsTheCpu) {
  const DepthImageTarget target = depthImageOf(test::thingsBeforeWall());
  Random random(8);
  std::vector<RayPath> rays(2000);
  std::generate(rays.begin(), rays.end(), [&] { return test::randomRay(random); });
  RayCost cpu;
  RayCost gpu;
  for (const RayCost& cost : test::castOnCpu(target, rays).costs) {
    cpu += cost;
  }
  for (const RayCost& cost : onGpu(target, rays).costs) {
    gpu += cost;
  }
  EXPECT_GT(cpu.steps(), rays.size());
  EXPECT_NEAR(static_cast<double>(gpu.steps()), static_cast<double>(cpu.steps()),
              0.01 * static_cast<double>(cpu.steps()));
  EXPECT_NEAR(static_cast<double>(gpu.boxes), static_cast<double>(cpu.boxes), 0.01 * static_cast<double>(cpu.boxes));
}

TEST_P(GlRayWalkTest, degenerateRaysHitNothing) {
  const DepthImageTarget target = depthImageOf(test::wall(0, 1));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  std::vector<StraightRay> rays{{{0, 0, 5}, {0, 0, 0}, 1},            // no direction
                                {{0, 0, 5}, {0, 0, -1e-16f}, 1},      // none that can be told
                                {{-5, 0.01f, 0}, {10, 0, 0}, 1},      // in the plane of the samples
                                {{0, 0, 5}, {0, 0, -4.5f}, 1},        // ends before them
                                {{0, 0, 5}, {0, 0, -10}, nan},        // reaches nowhere
                                {{0.3f, 0.3f, -5}, {0, 0, -10}, 1}};  // runs away from them
  for (const float bad : {nan, infinite, -infinite, 1e30f}) {
    rays.push_back({{bad, 0, 5}, {0, 0, -10}, 1});
    rays.push_back({{0, 0, 5}, {0, bad, -10}, 1});
    rays.push_back({{0, 0, bad}, {bad, bad, bad}, 1});
  }
  const size_t degenerate = rays.size();
  rays.push_back({{0, 0, 5}, {0, 0, -10}, 1});
  const GlScope scope(*context_);
  const std::vector<float> found = distances(GlRayWalk(*context_, target), rays);
  for (size_t i = 0; i < degenerate; ++i) {
    EXPECT_EQ(found[i], 0) << i;
  }
  EXPECT_NEAR(found.back(), 5, 1e-5f) << "and it is there to be hit";
}

TEST_P(GlRayWalkTest, fromInsideOfAnObjectItsSurfaceIsHitFromBehind) {
  const DepthImageTarget target = depthImageOf(test::ballBeforePlane());
  const std::vector<RayPath> rays{{{0, 0, 0}, {0, 0, 3}}, {{0.1f, 0.1f, 0.1f}, {0.1f, 0.4f, 3}}};
  const CastHits expected = test::castOnCpu(target, rays);
  EXPECT_EQ(test::metCount(expected), 2u);
  EXPECT_EQ(test::differingHits(expected, onGpu(target, rays)), 0u);
}

TEST_P(GlRayWalkTest, emptyImagesAreHitByNothing) {
  for (const DepthImageTarget& target :
       {DepthImageTarget({}), DepthImageTarget({blankReferenceImage("di", View{}, 5, 3)})}) {
    const CastHits got = onGpu(target, {{{0, 0, 5}, {0, 0, -5}}});
    EXPECT_FALSE(got.hits[0]);
    EXPECT_EQ(got.costs[0].steps(), 0u);
  }
  EXPECT_TRUE(onGpu(depthImageOf(test::wall(0, 1)), {}).hits.empty()) << "nor do no rays hit anything";
}

TEST_P(GlRayWalkTest, aSinglePixelIsItsSquare) {
  const DepthImageTarget target({buildDepthImage(PinholeCamera(View{}, 1, 1), test::wall(0, 20))});
  const CastHits got = onGpu(target, {{{0, 0, 5}, {0, 0, -5}}, {{5, 0, 5}, {5, 0, -5}}});
  ASSERT_TRUE(got.hits[0]);
  EXPECT_NEAR(got.hits[0]->position.z, 0, 1e-5f);
  EXPECT_FALSE(got.hits[1]);
}

// Rays that bend are cast on the CPU.
TEST_P(GlRayWalkTest, bentRaysHitAlongTheirPieces) {
  const DepthImageTarget target = depthImageOf(test::wall(0, 1));
  const CastHits got = onGpu(target, {{{0, 0, 2}, {0.25f, 0, 1}, {0.25f, 0, -3}}, RayPath{}, {{0, 0, 5}}});
  ASSERT_TRUE(got.hits[0]);
  EXPECT_LT(glm::distance(got.hits[0]->position, {0.25f, 0, 0}), 1e-5f);
  EXPECT_FALSE(got.hits[1] || got.hits[2]);
}

/// Triangles, one behind the other, that a ray along +z at (0.01, 0) passes by just beside their long edges, within the
/// boxes of all: no walk can take more steps. Behind them lies one that it hits.
SampleCells narrowMisses(uint32_t count) {
  Mesh mesh;
  for (uint32_t i = 0; i <= count; ++i) {
    const float z = static_cast<float>(i) * 1e-3f;
    const float x = i < count ? 0 : 1;
    mesh.positions.insert(mesh.positions.end(), {{x - 1, -1, z}, {x + 1, 1, z}, {x - 1, 1, z}});
    mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  return triangleCells(mesh);
}

// A software renderer ends shaders that take long: then the walk is given up, and says so. Below that it is right.
TEST_P(GlRayWalkTest, theLongestWalkEndsOrSaysThatItWasGivenUp) {
  const GlScope scope(*context_);
  const StraightRay longest{{0.01f, 0, -1}, {0, 0, 10}, 1};
  const StraightRay shortest{{-0.01f, 0, -1}, {0, 0, 10}, 1};
  for (const uint32_t count : {100u, 1400u, 3000u}) {
    const SampleCells cells = narrowMisses(count);
    const SamplePyramid pyramid(cells);
    RayCost cost;
    ASSERT_TRUE(pyramid.meet(longest, cost));
    ASSERT_EQ(cost.steps(), pyramid.maxSteps());
    const std::vector<float> found = distances(GlRayWalk(*context_, cells, pyramid), {longest, shortest});
    const bool isGivenUp = count == 3000 && context_->info().isSoftware;
    EXPECT_NEAR(found[0], isGivenUp ? kUnansweredDistance : 1 + static_cast<float>(count) * 1e-3f, 1e-5f) << count;
    EXPECT_NEAR(found[1], 1, 1e-6f) << "the first on its way";
  }
}

// One walk for images that change, with trees of other depths.
TEST_P(GlRayWalkTest, takesAnotherTarget) {
  const GlScope scope(*context_);
  const Mesh mesh = test::thingsBeforeWall();
  const DepthImageTarget small({buildDepthImage(PinholeCamera({}, 3, 2), mesh)});
  const DepthImageTarget large({buildDepthImage(PinholeCamera({}, 480, 320), mesh)});
  EXPECT_GT(large.pyramid().maxWaiting(), small.pyramid().maxWaiting());
  Random random(3);
  std::vector<StraightRay> rays(500);
  std::generate(rays.begin(), rays.end(), [&] {
    const RayPath path = test::randomRay(random);
    return StraightRay{path[0], path[1] - path[0], 1};
  });
  GlRayWalk walk(*context_, small);
  const std::vector<float> before = distances(walk, rays);
  walk.setTarget(large.cells(), large.pyramid());
  EXPECT_EQ(distances(walk, rays), distances(GlRayWalk(*context_, large), rays));
  walk.setTarget(small.cells(), small.pyramid());
  EXPECT_EQ(distances(walk, rays), before);
}

thread_local int memoryErrors = 0;

GLenum GLAD_API_PTR failForMemory() {
  return memoryErrors-- == 1 ? GL_OUT_OF_MEMORY : GL_NO_ERROR;
}

// Wherever OpenGL fails, an error says so and nothing is left behind.
TEST_P(GlRayWalkTest, aFullGpuIsReported) {
  const DepthImageTarget target = depthImageOf(test::wall(0, 1));
  const std::vector<RayPath> rays{{{0, 0, 5}, {0, 0, -5}}};
  const auto getError = context_->functions().GetError;
  onGpu(target, rays);
  context_->functions().GetError = failForMemory;
  int failing = 0;
  for (int call = 1;; ++call) {
    memoryErrors = call;
    try {
      onGpu(target, rays);
      break;
    } catch (const GlError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("not enough memory"));
      EXPECT_EQ(context_->liveObjects(), 0);
      ++failing;
    }
  }
  context_->functions().GetError = getError;
  EXPECT_GT(failing, 10) << "each step is checked";
}

TEST(RayImage, holdsEachRayOnce) {
  for (const size_t count : {size_t{0}, size_t{1}, size_t{64}, size_t{65}, size_t{20'000}}) {
    std::vector<StraightRay> rays(count);
    for (size_t i = 0; i < count; ++i) {
      rays[i].step = glm::vec3(static_cast<float>(i + 1));
    }
    const Image<StraightRay> image = rayImage(rays);
    size_t held = 0;
    for (const StraightRay& ray : image) {
      held += ray.step != glm::vec3(0);
    }
    EXPECT_EQ(held, count);
    for (size_t i = 0; i < count; ++i) {
      ASSERT_EQ(image[rayTexel(image, i)].step, rays[i].step);
    }
  }
}

}  // namespace
}  // namespace ocelli
