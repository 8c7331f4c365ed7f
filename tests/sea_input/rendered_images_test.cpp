// Images of seas that are rendered from scenes.
#include "oc_core/sea_input/rendered_images.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/geometric.hpp>

#include "oc_core/camera/panorama_camera.h"
#include "oc_core/image/color.h"
#include "oc_core/sea_input/sea_proxies.h"

namespace ocelli {
namespace {

Mesh coloredBox() {
  Mesh mesh = boxAround({{-1, -1, -1}, {2, 1, 3}}, {});
  for (const glm::vec3& p : mesh.positions) {
    mesh.colors.push_back(glm::vec3(p.x > 0, p.y > 0, p.z > 0) * 0.7f + 0.1f);
  }
  return mesh;
}

TEST(RenderedImages, AreWhatThePanoramaCameraSees) {
  const Mesh mesh = coloredBox();
  const glm::vec3 eye(0.3f, 0.1f, -0.2f);
  const SeaProjection projection{.width = 64, .height = 32};
  const RenderedImages images("a box", mesh, {{glm::dvec3(eye), glm::dquat(1, 0, 0, 0)}},
                              {projection, 1, glm::vec3(0)});
  View view;
  view.eye = eye;
  view.target = eye + glm::vec3(0, 0, -1);
  view.fovVerticalDegrees = 60;
  const PanoramaCamera camera(PinholeCamera(view, 64, 32));
  const RayScene rays(mesh);
  const Image<Rgb8> expected = srgbFromLinear(colorImage(raycast(camera, mesh, rays), mesh, glm::vec3(0)));
  const Image<Rgb8> found = images.image(0);
  for (size_t i = 0; i < found.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      ASSERT_LE(std::abs(int{found[i][c]} - int{expected[i][c]}), 1) << i;
    }
  }
}

TEST(RenderedImages, PixelsAreMeansOfTheirSamples) {
  const Mesh mesh = coloredBox();
  const SeaPose pose{{0, 0, 0}, glm::dquat(1, 0, 0, 0)};
  const SeaProjection fine{.width = 128, .height = 64};
  const SeaProjection coarse{.width = 64, .height = 32};
  const Image<Rgb8> many = RenderedImages("a box", mesh, {pose}, {fine, 1, glm::vec3(0)}).image(0);
  const Image<Rgb8> mean = RenderedImages("a box", mesh, {pose}, {coarse, 2, glm::vec3(0)}).image(0);
  const Image<Rgb8> once = RenderedImages("a box", mesh, {pose}, {coarse, 1, glm::vec3(0)}).image(0);
  int differs = 0;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      float sum = 0;
      for (const glm::ivec2 at : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
        sum += linearFromSrgbByte(many(2 * x + at.x, 2 * y + at.y).r) / 4;
      }
      EXPECT_NEAR(mean(x, y).r, srgbByteFromLinear(sum), 2) << x << " " << y;
      differs += mean(x, y).r != once(x, y).r ? 1 : 0;
    }
  }
  EXPECT_GT(differs, 10);
}

TEST(SeaProxies, ABoxHoldsPositionsAndMostPoints) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i <= 100; ++i) {
    points.emplace_back(i / 50.0 - 1, (i % 10) / 10.0, (i % 7) / 7.0);
  }
  points.emplace_back(1000, 0, 0);  // an outlier
  const Box box = boundsOf(boxAround({{3, 0.5, 0.5}}, points));
  EXPECT_NEAR(box.lower.x, -1, 0.1);
  EXPECT_NEAR(box.upper.x, 3, 0.1);
  EXPECT_EQ(boxAround({{3, 0.5, 0.5}}, points).triangles.size(), 12u);
}

}  // namespace
}  // namespace ocelli
