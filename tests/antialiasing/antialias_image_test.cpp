// Images with antialiasing against answers by hand, rays, and themselves.
#include <gtest/gtest.h>

#include "oc_core/antialiasing/ray_samples.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/random.h"
#include "oc_core/render/rasterize.h"
#include "tests/antialiasing/antialias_scenes.h"

namespace ocelli::test {
namespace {

constexpr glm::vec3 kWhite(1);

std::vector<PixelRule> allRules() {
  return {squareRule(1, "grid"),
          multisampleRule(2),
          multisampleRule(4),
          multisampleRule(8),
          multisampleRule(16),
          squareRule(4, "grid"),
          squareRule(4, "sheared"),
          squareRule(4, "jittered"),
          squareRule(8, "grid", 8),
          squareRule(8, "sheared", 16),
          squareRule(32, "jittered", 2),
          squareRule(7, "slanted"),
          squareRule(32, "slanted"),
          squareRule(16, "slanted", 3),
          squareRule(40, "slanted")};
}

TEST(AntialiasImage, halfAPixelIsHalfItsColour) {
  const PinholeCamera camera = flatCamera(16, 12);
  Mesh mesh;
  // The part of the image left of u = 5.5; pixels of column 5 are half white.
  addFlat(mesh, {-50, -50}, {5.5f, -50}, {5.5f, 50}, kWhite, camera);
  addFlat(mesh, {-50, -50}, {5.5f, 50}, {-50, 50}, kWhite, camera);
  const AntialiasScene scene(camera, mesh);
  for (const PixelRule& rule : {squareRule(8, "grid"), squareRule(8, "sheared"), squareRule(8, "sheared", 8)}) {
    const Image<glm::vec3> image = scene.draw(everywhere(rule), glm::vec3(0));
    for (int y = 0; y < 12; ++y) {
      EXPECT_EQ(image(4, y).x, 1);
      // Vertices are snapped to 1/4096 pixel.
      EXPECT_NEAR(image(5, y).x, 0.5f, 1.0f / 4096);
      EXPECT_EQ(image(6, y).x, 0);
    }
  }
  // Of the 16 positions of Direct3D, eight have an offset below 0, one 0.
  EXPECT_NEAR(scene.draw(everywhere(multisampleRule(16)), glm::vec3(0))(5, 3).x, 0.5f, 0.5f / 16 + 1e-6f);
}

TEST(AntialiasImage, trianglesThatShareEdgesLeaveNoGapsAndCountOnce) {
  // A fan of slivers around points in the image, over all of it, half transparent if it counted twice.
  const PinholeCamera camera = flatCamera(40, 30);
  Random random(3);
  Mesh mesh;
  const glm::vec2 corners[] = {{-9, -9}, {49, -9}, {49, 39}, {-9, 39}};
  for (int i = 0; i < 4; ++i) {
    const glm::vec2 from = corners[i];
    const glm::vec2 to = corners[(i + 1) % 4];
    float last = 0;
    while (last < 1) {
      const float next = std::min(last + random.inRange(0.001f, 0.05f), 1.0f);
      addFlat(mesh, {17.3f, 12.9f}, glm::mix(from, to, last), glm::mix(from, to, next), kWhite, camera);
      last = next;
    }
  }
  const AntialiasScene scene(camera, mesh);
  for (const PixelRule& rule : allRules()) {
    const Image<glm::vec3> image = scene.draw(everywhere(rule), glm::vec3(0));
    for (const glm::vec3& pixel : image) {
      EXPECT_NEAR(pixel.x, 1, 2e-6);  // of the sum of up to 1,024 weights
    }
  }
}

TEST(AntialiasImage, oneSampleIsTheRasterisersImage) {
  const PinholeCamera camera({}, 90, 60);
  const Mesh mesh = triangleCloud(3000, 0.05f);
  const Image<glm::vec3> image = AntialiasScene(camera, mesh).draw(everywhere(squareRule(1, "grid")), kNight);
  const Image<glm::vec3> expected = colorImage(rasterize(camera, mesh), mesh, kNight);
  size_t different = 0;
  for (size_t i = 0; i < image.size(); ++i) {
    different += glm::distance(image[i], expected[i]) > 1e-4f ? 1 : 0;
  }
  // Vertices are snapped to 1/256 pixel there, to 1/4096 here: of about 5 edges a pixel in each direction, 5 / 256
  // pixels of 1 lie on the other side, a third of them with a surface behind that is not the same.
  EXPECT_LT(different, image.size() / 50);
}

TEST(AntialiasImage, samplesSeeWhatRaysSee) {
  const PinholeCamera camera({}, 60, 40);
  const Mesh mesh = triangleCloud(4000, 0.03f);
  const RayScene rays(mesh);
  for (const char* placement : {"grid", "sheared", "slanted", "jittered"}) {
    const PixelRule rule = squareRule(8, placement);
    const Image<glm::vec3> image = AntialiasScene(camera, mesh).draw(everywhere(rule), kNight);
    const Image<glm::vec3> expected = raySampledImage(
        60, 40, [&](const glm::vec2& p) { return camera.rayPath(p); }, rays, *rule.pattern, kNight);
    // One of 64 samples of few pixels differs where it lies within rounding of an edge.
    EXPECT_LT(rmse(image, expected), 1e-3) << placement;
    EXPECT_LT(greatestDifference(image, expected), 3.0 / 64) << placement;
  }
}

TEST(AntialiasImage, generalPinholesSamplesSeeWhatRaysSee) {
  const PinholeCamera reference({}, 60, 40);
  const Mesh mesh = triangleCloud(1500, 0.08f);
  const RayScene rays(mesh);
  for (const GpcSampling& sampling : gpcSamplings()) {
    const GpcCamera camera(reference, {&sampling, {{{0.4f, 0.5f}, {0.3f, 0.4f}, 3, 1}}});
    const PixelRule rule = squareRule(6, "slanted");
    const Image<glm::vec3> image = AntialiasScene(camera, mesh).draw(everywhere(rule), kNight);
    const Image<glm::vec3> expected = raySampledImage(
        60, 40, [&](const glm::vec2& p) { return camera.rayPath(p); }, rays, *rule.pattern, kNight);
    EXPECT_LT(rmse(image, expected), 2e-3) << sampling.name;
    EXPECT_LT(greatestDifference(image, expected), 3.0 / 36) << sampling.name;
    // By area where pixels are squares, by samples where they are bent.
    const Image<glm::vec3> areas = AntialiasScene(camera, mesh).draw(everywhere(squareRule(32, "sheared", 8)), kNight);
    EXPECT_LT(rmse(areas, expected), 0.02) << sampling.name;  // of 36 samples
  }
}

TEST(AntialiasImage, isTheSameForAnyNumberOfThreads) {
  const PinholeCamera camera({}, 90, 60);
  const Mesh mesh = triangleCloud(20000, 0.03f);
  const int before = threadCount();
  for (const PixelRule& rule : allRules()) {
    setThreadCount(1);
    const Image<glm::vec3> alone = AntialiasScene(camera, mesh).draw(everywhere(rule), kNight);
    setThreadCount(4);
    EXPECT_EQ(AntialiasScene(camera, mesh).draw(everywhere(rule), kNight), alone);
  }
  setThreadCount(before);
}

TEST(AntialiasImage, clipsWhatComesThroughTheEyePlane) {
  View view;
  view.eye = {0, 0.3f, 0};
  view.target = {0, 0.3f, -1};
  view.fovVerticalDegrees = 60;
  const PinholeCamera camera(view, 48, 32);
  Mesh mesh;  // a floor that goes on behind the eye
  mesh.positions = {{-50, 0, -50}, {50, 0, -50}, {50, 0, 50}, {-50, 0, 50}};
  mesh.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const PixelRule rule = squareRule(8, "sheared");
  const Image<glm::vec3> expected = raySampledImage(
      48, 32, [&](const glm::vec2& p) { return camera.rayPath(p); }, RayScene(mesh), *rule.pattern, kNight);
  // A sample or two at the horizon, where a float's rounding is much of the distance.
  EXPECT_LT(greatestDifference(AntialiasScene(camera, mesh).draw(everywhere(rule), kNight), expected), 2.5 / 64);
  EXPECT_LT(
      greatestDifference(AntialiasScene(camera, mesh).draw(everywhere(squareRule(8, "sheared", 8)), kNight), expected),
      3.0 / 64);
}

TEST(AntialiasImage, errorBecomesSmallerWithSamples) {
  const PinholeCamera camera({}, 48, 32);
  const Mesh mesh = triangleCloud(30000, 0.02f);
  const AntialiasScene scene(camera, mesh);
  const Image<glm::vec3> truth = scene.draw(everywhere(squareRule(64, "jittered")), kNight);
  const auto error = [&](const PixelRule& rule) { return rmse(scene.draw(everywhere(rule), kNight), truth); };
  const double msaa = error(multisampleRule(16));
  // Independent samples would halve the error from one to the next; those in strata do better.
  EXPECT_LT(error(squareRule(8, "sheared")), msaa / 2);
  EXPECT_LT(error(squareRule(16, "sheared")), msaa / 4);
  EXPECT_LT(error(squareRule(32, "sheared")), msaa / 8);
  EXPECT_GT(error(squareRule(1, "grid")), msaa * 2);
}

TEST(AntialiasImage, aPixelThatOneTriangleFillsTakesNoSamples) {
  const PinholeCamera camera = flatCamera(64, 64);
  Mesh mesh;
  addFlat(mesh, {-100, -100}, {300, -100}, {-100, 300}, kWhite, camera, 5);
  for (int i = 0; i < 500; ++i) {  // behind it
    const auto x = static_cast<float>(i % 60);
    addFlat(mesh, {x, 3}, {x + 3, 7}, {x, 60}, {1, 0, 0}, camera, 1);
  }
  AntialiasWork work;
  AntialiasScene(camera, mesh).draw(everywhere(squareRule(32, "sheared")), kNight, &work);
  EXPECT_EQ(work.plain, 64U * 64U);
  EXPECT_EQ(work.samples, 0U);
}

}  // namespace
}  // namespace ocelli::test
