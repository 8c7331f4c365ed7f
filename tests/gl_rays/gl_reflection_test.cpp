// Pictures with mirrors, drawn on the GPU alone, against those of `ocelli shade`.
#include "oc_core/gl_rays/gl_reflection.h"

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

class GlReflectionTest : public testing::TestWithParam<GlProvider> {
 protected:
  ~GlReflectionTest() override { EXPECT_EQ(context_->liveObjects(), 0); }

  const std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlReflectionTest, kOffscreenProviders, providerName);

// One picture by two renderers, of which one casts what the other rasterises: as many as 0.5 % of the pixels that show
// mirrors may differ.
TEST_P(GlReflectionTest, drawsWhatShadeDraws) {
  const ShadedScene scene = loadShadedScene("builtin:mirror", rolesFor("builtin:mirror", ""));
  const Mesh direct = test::directPart(scene, scene.mirrors);
  const test::MirrorMesh mirrors(scene.mirrors);
  const Box box = boundsOf(scene.mirrors);
  const PinholeCamera camera(pictureView(box), 240, 160);
  const PinholeCamera reference(referenceView(scene.cast, box, 240, 160), 240, 160);
  const EnvironmentMap map(box.center(), scene.surroundings, 256, shadeBackground());
  const SecondaryRays rays = reflectedRays(FirstSurfaces(scene, scene.mirrors), camera);
  const Progress none;
  const CastObjects cast = castObjects(scene, nullptr);
  const GlScope scope(*context_);
  const DepthImageTarget before({});
  GlReflection reflection(*context_, mirrors.mesh, mirrors.normals,
                          {direct, before, scene.billboards, map.image(), shadeBackground()});
  for (const char* name : {"di", "spoc", "cell", "ldi-4"}) {
    const ViewCell cell{.sideRadii = 1};
    const DepthImageTarget target(buildReferenceImages(cameraChoice(name, cell), reference, scene.cast));
    reflection.setTarget(target);
    const Image<glm::vec3> got = readPicture(*context_, reflection.draw(camera), camera);
    const BuiltProxy built = buildProxy(specularWay(name), {scene, cast, box.center(), reference, cell, 256, none});
    const size_t differing = differingPixels(shade(rays, *built.proxy).color, got);
    EXPECT_LE(differing, rays.rays.size() / 200) << name;
    testing::Test::RecordProperty(name, std::to_string(differing));
    EXPECT_GT(differingPixels(rays.base, got), rays.rays.size() / 2) << "mirrors show something";
  }
}

// A mirror at z = 0 sees a red box before it, a green wall behind the eye, and the sky.
TEST_P(GlReflectionTest, mirrorsABoxWhereItIs) {
  const ShadedScene scene = test::mirrorBeforeBox();
  const Mesh direct = test::directPart(scene, scene.mirrors);
  const test::MirrorMesh mirrors(scene.mirrors);
  const GlScope scope(*context_);
  View view;
  view.eye = {0, 0, 5};
  const PinholeCamera camera(view, 91, 61);
  View towards;
  towards.eye = {0, 0, 0};
  towards.target = {0.25f, 0.2f, 2};
  towards.fovVerticalDegrees = 20;
  const DepthImageTarget target({buildDepthImage(PinholeCamera(towards, 90, 60), scene.cast)});
  const Image<glm::vec3> sky(4, 2, glm::vec3(0.2f, 0.3f, 0.4f));
  const Mesh nothing;
  const auto colorAt = [&](const GlReflection& reflection, const glm::vec3& mirrored) {
    // What stands at z before the mirror is seen at -z through it.
    const auto q = camera.project({mirrored.x, mirrored.y, -mirrored.z});
    return readPicture(*context_, reflection.draw(camera), camera)(static_cast<int>(q->u), static_cast<int>(q->v));
  };
  const GlReflection reflection(*context_, mirrors.mesh, mirrors.normals,
                                {direct, target, scene.billboards, sky, glm::vec3(1)});
  EXPECT_LT(glm::distance(colorAt(reflection, {0.25f, 0.2f, 1.9f}), {0.8f, 0.1f, 0.1f}), 1e-5f);
  EXPECT_LT(glm::distance(colorAt(reflection, {-0.25f, -0.2f, 1.9f}), {0.1f, 0.6f, 0.1f}), 1e-5f) << "the wall";
  const GlReflection open(*context_, mirrors.mesh, mirrors.normals, {direct, target, nothing, sky, glm::vec3(1)});
  EXPECT_LT(glm::distance(colorAt(open, {-0.25f, -0.2f, 1.9f}), {0.2f, 0.3f, 0.4f}), 1e-5f) << "the sky";
}

TEST_P(GlReflectionTest, aPictureOfNothingIsTheBackground) {
  const Mesh nothing;
  const DepthImageTarget target({});
  const Image<glm::vec3> sky(2, 1, glm::vec3(0.5f));
  const GlScope scope(*context_);
  const GlReflection reflection(*context_, nothing, {}, {nothing, target, nothing, sky, {0.1f, 0.2f, 0.3f}});
  const PinholeCamera camera(View{}, 1, 1);
  EXPECT_EQ(readPicture(*context_, reflection.draw(camera), camera)(0, 0), glm::vec3(0.1f, 0.2f, 0.3f));
}

}  // namespace
}  // namespace ocelli
