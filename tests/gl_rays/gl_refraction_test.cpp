// Pictures with objects of glass, drawn on the GPU alone, against those of `ocelli shade`.
#include "oc_core/gl_rays/gl_refraction.h"

#include <gtest/gtest.h>

#include "oc_core/ocri/camera_choice.h"
#include "oc_core/shade/environment_map.h"
#include "oc_core/shade/scene_proxies.h"
#include "oc_core/shade/shade_comparison.h"
#include "tests/gl/gl_test_context.h"
#include "tests/gl_rays/ray_picture_parts.h"
#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

using test::differingPixels;
using test::readPicture;

std::vector<GlassObject> glassOf(const std::vector<SpecularObject>& objects) {
  std::vector<GlassObject> glass;
  for (const SpecularObject& object : objects) {
    glass.push_back({object.mesh, object.normals, static_cast<float>(object.refractiveIndex)});
  }
  return glass;
}

class GlRefractionTest : public testing::TestWithParam<GlProvider> {
 protected:
  ~GlRefractionTest() override { EXPECT_EQ(context_->liveObjects(), 0); }

  /// By a depth image, as many as `share` of the pixels that show glass may differ from those of `ocelli shade`.
  void expectAgreement(const ShadedScene& scene, const View& view, double share) {
    const Mesh direct = test::directPart(scene, scene.lenses);
    const Box box = boundsOf(scene.lenses);
    const PinholeCamera camera(view, 240, 160);
    const PinholeCamera reference(referenceView(scene.cast, box, 240, 160), 240, 160);
    const EnvironmentMap map(box.center(), scene.surroundings, 256, shadeBackground());
    const SecondaryRays rays = refractedRays(FirstSurfaces(scene, scene.lenses), camera);
    ASSERT_GT(rays.rays.size(), 500u);
    const Progress none;
    const ViewCell cell{.sideRadii = 1};
    const DepthImageTarget target(buildReferenceImages(cameraChoice("di", cell), reference, scene.cast));
    const GlScope scope(*context_);
    const GlRefraction refraction(*context_, glassOf(scene.lenses),
                                  {direct, target, scene.billboards, map.image(), shadeBackground()});
    const Image<glm::vec3> got = readPicture(*context_, refraction.draw(camera), camera);
    const CastObjects cast = castObjects(scene, nullptr);
    const BuiltProxy built = buildProxy(specularWay("di"), {scene, cast, box.center(), reference, cell, 256, none});
    const size_t differing = differingPixels(shade(rays, *built.proxy).color, got);
    EXPECT_LE(static_cast<double>(differing), share * static_cast<double>(rays.rays.size()));
    EXPECT_GT(differingPixels(rays.base, got), rays.rays.size() / 2) << "glass shows something";
    testing::Test::RecordProperty("differing", std::to_string(differing));
    testing::Test::RecordProperty("of", std::to_string(rays.rays.size()));
  }

  const std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlRefractionTest, kOffscreenProviders, providerName);

TEST_P(GlRefractionTest, drawsWhatShadeDraws) {
  const ShadedScene scene = loadShadedScene("builtin:lens", rolesFor("builtin:lens", ""));
  expectAgreement(scene, pictureView(boundsOf(scene.lenses)), 0.005);
}

// Two panes and a ball before a box and a wall, of glass of their own; one pane hides a part of the ball.
TEST_P(GlRefractionTest, objectsHideOneAnother) {
  ShadedScene scene;
  append(scene.cast, makeBox(glm::vec3(0.4f)), glm::translate(glm::mat4(1), {0, 0, -2}));
  paint(scene.cast, {0.7f, 0.3f, 0.1f});
  test::addWall(scene.billboards, -4, 10, {0.1f, 0.6f, 0.1f});
  const auto add = [&](Mesh mesh, const glm::vec3& at, double index) {
    Mesh moved;
    append(moved, mesh, glm::translate(glm::mat4(1), at));
    scene.lenses.push_back(test::specularObject(std::move(moved), index));
  };
  add(makeBox({0.3f, 0.4f, 0.05f}), {0.3f, 0, 0.8f}, 1.3);
  Mesh ball;
  append(ball, makeSphere(32), glm::scale(glm::mat4(1), glm::vec3(0.4f)));
  add(ball, {0, 0, 0}, 1.5);
  add(makeBox({0.2f, 0.3f, 0.05f}), {-0.5f, 0.1f, -0.5f}, 1.7);
  View view;
  view.eye = {0, 0, 5};
  view.fovVerticalDegrees = 20;
  expectAgreement(scene, view, 0.005);
}

TEST_P(GlRefractionTest, withoutGlassThePictureIsTheViewItself) {
  const Mesh wall = test::wall(0, 1);
  const Mesh nothing;
  const DepthImageTarget target({});
  const Image<glm::vec3> sky(2, 1, glm::vec3(0.5f));
  const GlScope scope(*context_);
  const GlRefraction refraction(*context_, {}, {wall, target, nothing, sky, {0.1f, 0.2f, 0.3f}});
  const PinholeCamera camera(View{}, 30, 20);
  const Image<glm::vec3> got = readPicture(*context_, refraction.draw(camera), camera);
  EXPECT_EQ(got(15, 10), wall.color(0));
  EXPECT_EQ(got(0, 0), glm::vec3(0.1f, 0.2f, 0.3f));
}

}  // namespace
}  // namespace ocelli
