// Steps along projected rays on the GPU, against those on the CPU.
#include "oc_core/gl_rays/gl_stepped_image.h"

#include <gtest/gtest.h>

#include <limits>

#include "oc_core/gl/gl_api.h"
#include "oc_core/ocri/cast_representation.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/ocri/spoc_builder.h"
#include "tests/depth_rays/sampled_scenes.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

using test::smallCamera;

/// What a ray meets: as GlSteppedHits has it.
struct SteppedHit {
  float distance = 0;
  glm::vec2 place{0};
  float opacity = 0;
  size_t steps = 0;
};

class GlSteppedImageTest : public testing::TestWithParam<GlProvider> {
 protected:
  ~GlSteppedImageTest() override { EXPECT_EQ(context_->liveObjects(), 0); }

  std::vector<SteppedHit> onGpu(const GlSteppedImage& stepped, const std::vector<StraightRay>& rays) const {
    const Image<StraightRay> image = rayImage(rays);
    const GlSteppedHits found = stepped.walk(GlRays(*context_, image));
    const auto hits = readTexture<glm::vec4>(*context_, found.hits, image.width(), image.height(), GL_RGBA, GL_FLOAT);
    const auto costs = readTexture<glm::uvec4>(*context_, found.costs, image.width(), image.height(), GL_RGBA_INTEGER,
                                               GL_UNSIGNED_INT);
    std::vector<SteppedHit> result;
    for (size_t i = 0; i < rays.size(); ++i) {
      const size_t texel = rayTexel(image, i);
      result.push_back({hits[texel].x, {hits[texel].y, hits[texel].z}, hits[texel].w, costs[texel].x + costs[texel].y});
    }
    return result;
  }

  /// Rays at what the camera sees: 99.5 % of those that meet something meet it where they do on the CPU.
  template <Camera C>
  void expectAgreement(const char* name, const C& camera) {
    const Mesh mesh = test::thingsBeforeWall();
    const ReferenceImage image = placedImage(camera, mesh, RayScene(mesh), smallCamera().view(), name);
    const CameraMap map = mapOf(camera);
    for (const double fine : {1.0, 0.25}) {
      const SteppedImage stepped(image, map, {.finePixels = fine});
      Random random(17);
      std::vector<StraightRay> rays(3000);
      for (StraightRay& ray : rays) {
        const glm::vec3 origin(random.inRange(-1, 1), random.inRange(-1, 1), random.inRange(1, 3));
        const glm::vec3 aim(random.inRange(-0.8f, 0.8f), random.inRange(-0.8f, 0.8f), -0.4f);
        ray = {origin, (aim - origin) * 3.0f, 1};
      }
      const GlScope scope(*context_);
      const std::vector<SteppedHit> got = onGpu(GlSteppedImage(*context_, stepped, camera), rays);
      size_t met = 0;
      size_t differing = 0;
      RayCost cost;
      size_t steps = 0;
      for (size_t i = 0; i < rays.size(); ++i) {
        const auto expected = stepped.meet(rays[i], cost);
        const float distance = expected ? static_cast<float>(expected->share) * glm::length(rays[i].step) : 0;
        met += expected.has_value();
        // Places are rounded by some 1e-5 pixels, which are 1e-6 of the world's units; a ray along a surface makes that
        // more.
        differing += std::abs(distance - got[i].distance) > 1e-4f ||
                     (expected && glm::distance(glm::vec2(expected->place), got[i].place) > 0.01f) ||
                     (expected && std::abs(static_cast<float>(expected->opacity) - got[i].opacity) > 0.01f);
        steps += got[i].steps;
        ASSERT_LE(got[i].steps, SteppedImage::maxSteps());
      }
      EXPECT_GT(met, 500u) << name;
      EXPECT_LE(differing, met / 200) << name << ", fine steps of " << fine;
      testing::Test::RecordProperty(std::string(name) + (fine < 1 ? ", fine" : ""), std::to_string(differing));
      EXPECT_NEAR(static_cast<double>(steps), static_cast<double>(cost.steps()),
                  0.005 * static_cast<double>(cost.steps()))
          << name;
    }
  }

  const std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlSteppedImageTest, kOffscreenProviders, providerName);

TEST_P(GlSteppedImageTest, meetsWhatTheCpuMeets) {
  const Mesh mesh = test::thingsBeforeWall();
  expectAgreement("di", smallCamera());
  expectAgreement("rppc", buildReversePinhole(smallCamera(), mesh));
  expectAgreement("spoc", buildSpocCamera(smallCamera(), mesh));
  expectAgreement("ddoc", buildDdocCamera(smallCamera(), mesh));
  expectAgreement("eoc-h", buildEpipolarCamera(smallCamera(), segmentAround(View{}, kHorizontalSegment, 1.6f), mesh));
  expectAgreement("eoc-v", buildEpipolarCamera(smallCamera(), segmentAround(View{}, kVerticalSegment, 1.6f), mesh));
  expectAgreement("eoc-forward", buildEpipolarCamera(smallCamera(), segmentAround(View{}, {0, 0, -1}, 1.6f), mesh));
}

TEST_P(GlSteppedImageTest, degenerateRaysMeetNothing) {
  const ReferenceImage image = buildDepthImage(smallCamera(), test::wall(0, 1));
  const CameraMap map = mapOf(smallCamera());
  const SteppedImage stepped(image, map);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<StraightRay> rays{{{0, 0, 5}, {0, 0, 0}, 1},     {{-5, 0.01f, 0}, {10, 0, 0}, 1},
                                {{0, 0, 5}, {0, 0, -4}, 1},    {{nan, 0, 5}, {0, 0, -10}, 1},
                                {{0, 0, 5}, {0, nan, -10}, 1}, {{0, 0, 5}, {0, 1e30f, -10}, 1}};
  const size_t degenerate = rays.size();
  rays.push_back({{0.1f, 0, 5}, {0, 0, -10}, 1});
  const GlScope scope(*context_);
  const std::vector<SteppedHit> found = onGpu(GlSteppedImage(*context_, stepped, smallCamera()), rays);
  for (size_t i = 0; i < degenerate; ++i) {
    EXPECT_EQ(found[i].distance, 0) << i;
    EXPECT_EQ(found[i].opacity, 0) << i;
  }
  EXPECT_NEAR(found.back().distance, 5, 1e-4f);
  EXPECT_EQ(found.back().opacity, 1);
}

TEST_P(GlSteppedImageTest, emptyImagesAndSinglePixelsAreNoSurface) {
  const ReferenceImage empty = blankReferenceImage("di", View{}, 5, 3);
  const PinholeCamera one(View{}, 1, 1);
  const ReferenceImage pixel = buildDepthImage(one, test::wall(0, 20));
  const GlScope scope(*context_);
  for (const ReferenceImage* image : {&empty, &pixel}) {
    const PinholeCamera camera = image->reference();
    const CameraMap map = mapOf(camera);
    const SteppedImage stepped(*image, map);
    const StraightRay ray{{0.2f, 0, 5}, {0, 0, -9}, 1};
    RayCost cost;
    const auto expected = stepped.meet(ray, cost);
    const std::vector<SteppedHit> found = onGpu(GlSteppedImage(*context_, stepped, camera), {ray});
    EXPECT_NEAR(found[0].distance, expected ? static_cast<float>(expected->share) * 9 : 0, 1e-4f);
  }
}

}  // namespace
}  // namespace ocelli
