// Reference images of what is no mesh, where what rays are cast at is a mesh after all: the images must be the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/target_renderer.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::sameBytes;
using test::smallCamera;
using testing::HasSubstr;

void expectSame(const ReferenceImages& images, const ReferenceImages& wanted) {
  ASSERT_EQ(images.size(), wanted.size());
  for (size_t i = 0; i < images.size(); ++i) {
    EXPECT_TRUE(sameBytes(images[i].t, wanted[i].t));
    EXPECT_TRUE(sameBytes(images[i].held, wanted[i].held));
    // Of weights at the corners of a triangle, which may differ by rounding where the point is the same.
    for (size_t pixel = 0; pixel < wanted[i].color.size(); ++pixel) {
      EXPECT_LT(glm::distance(images[i].color[pixel], wanted[i].color[pixel]), 1e-6f);
    }
    EXPECT_TRUE(sameBytes(images[i].displacement, wanted[i].displacement));
    EXPECT_TRUE(sameBytes(images[i].position, wanted[i].position));
    EXPECT_EQ(images[i].camera, wanted[i].camera);
    EXPECT_EQ(images[i].triangleBound, wanted[i].triangleBound);
    EXPECT_EQ(images[i].rows, wanted[i].rows);
  }
}

class TargetImages : public testing::TestWithParam<const char*> {};

TEST_P(TargetImages, AreThoseOfTheMeshThatRaysAreCastAt) {
  const Mesh scene = test::boxBeforeWall();
  const RayScene rays(scene);
  const CameraChoice choice = cameraChoice(GetParam());
  const TargetRenderer target(rays);
  const ReferenceImages images = buildReferenceImages(choice, smallCamera(), target);
  expectSame(images, buildReferenceImages(choice, smallCamera(), scene, {}, Construction::kRays, &rays));
  EXPECT_GT(images[0].sampleCount(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Cameras, TargetImages,
                         testing::Values("di", "gpc", "spoc", "di+spoc", "ddoc", "ddoc-paper", "eoc-h", "eoc-v",
                                         "eoc-forward", "eoc-hv", "eoc-hv+ddoc", "cell", "panorama", "cylinder"),
                         [](const auto& each) {
                           std::string name = each.param;
                           std::ranges::replace_if(
                               name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
                           return name;
                         });

/// Cameras that meshes are rasterised for.
TEST(TargetImagesOfCorners, AreWhatTheCornersSee) {
  const Mesh scene = test::boxBeforeWall();
  const RayScene rays(scene);
  const RayRenderer byRays(scene, rays);
  for (const char* name : {"corners-4", "rppc"}) {
    const CameraChoice choice = cameraChoice(name);
    expectSame(buildReferenceImages(choice, smallCamera(), TargetRenderer(rays)),
               buildReferenceImages(choice, smallCamera(), scene, {}, byRays));
  }
}

TEST(TargetImagesOfTheBox, AreWideEnoughForTheBoxAroundIt) {
  const Mesh scene = test::boxBeforeWall(0.9f);
  const RayScene rays(scene);
  const CameraChoice choice = cameraChoice("di-wide");
  const ReferenceImages images = buildReferenceImages(choice, smallCamera(), TargetRenderer(rays));
  const ReferenceImages ofMesh = buildReferenceImages(choice, smallCamera(), scene);
  EXPECT_GE(images[0].width(), ofMesh[0].width());
  EXPECT_GE(images[0].sampleCount(), ofMesh[0].sampleCount() * 99 / 100);
}

TEST(TargetImagesOfLayers, AreWhatEachRayHitsBehindTheLastHit) {
  Mesh scene = test::wall(0.5f, 0.4f);
  test::addWall(scene, -0.25f, 3);
  test::addWall(scene, -0.75f, 3);
  const RayScene rays(scene);
  const TargetRenderer target(rays, [](const RayPath& ray, const Hit& hit) {
    RayPath rest;
    rest.add(ray.pointAt(ray.positionAt(hit.t + 0.01f)), hit.t + 0.01f);
    rest.add(ray.back(), ray.tMax());
    return rest;
  });
  const PinholeCamera camera = smallCamera();
  const ReferenceImages layers = buildReferenceImages(cameraChoice("ldi-4"), camera, target);
  ASSERT_EQ(layers.size(), 3u);
  const int x = camera.width() / 2;
  const int y = camera.height() / 2;
  EXPECT_NEAR(layers[0].t(x, y), 9.5f, 1e-4f);
  EXPECT_NEAR(layers[1].t(x, y), 10.25f, 1e-4f);
  EXPECT_NEAR(layers[2].t(x, y), 10.75f, 1e-4f);
  EXPECT_NEAR(layers[0].t(1, 1), 10.25f, 1e-4f);
  EXPECT_NEAR(layers[1].t(1, 1), 10.75f, 1e-4f);
  EXPECT_FALSE(layers[2].holds(1, 1));
  EXPECT_EQ(layers[2].layer, 2);
}

TEST(TargetImagesErrors, SayWhatToDo) {
  const Mesh scene = test::wall(0);
  const RayScene rays(scene);
  const auto errorOf = [&](const char* name, const PinholeCamera& camera) -> std::string {
    try {
      buildReferenceImages(cameraChoice(name), camera, TargetRenderer(rays));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(errorOf("geometry", smallCamera()), HasSubstr("is made of triangles"));
  View away;
  away.target = {0, 0, 20};
  EXPECT_THAT(errorOf("di", PinholeCamera(away, 30, 20)), HasSubstr("no ray of the view hits the scene"));
}

TEST(TargetImagesMaps, AreThoseOfTheMesh) {
  const Mesh scene = test::boxBeforeWall();
  const RayScene rays(scene);
  const RayRenderer byRays(scene, rays);
  const CameraChoice choice = cameraChoice("ddoc");
  const TargetRenderer target(rays);
  const ReferenceImages images = buildReferenceImages(choice, smallCamera(), target);
  const std::vector<CameraMap> maps = cameraMaps(choice, smallCamera(), target, images);
  const std::vector<CameraMap> wanted = choice.kind->maps({choice, smallCamera(), scene, {}, &byRays}, images);
  ASSERT_EQ(maps.size(), 1u);
  for (const glm::vec2& pixel : {glm::vec2(30.5f, 30.5f), glm::vec2(33.5f, 22.5f), glm::vec2(5.5f, 5.5f)}) {
    EXPECT_TRUE(maps[0].ray(pixel) == wanted[0].ray(pixel));
  }
}

}  // namespace
}  // namespace ocelli
