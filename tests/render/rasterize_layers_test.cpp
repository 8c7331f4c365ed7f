#include "oc_core/render/rasterize_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "oc_core/base/parallel.h"
#include "oc_core/render/rasterize.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

Mesh triangleOf(const Mesh& mesh, size_t triangle) {
  Mesh single = mesh;
  single.triangles = {mesh.triangles[triangle]};
  return single;
}

/// The slow reference: each triangle drawn by itself, the fragments of a pixel sorted.
std::vector<FragmentImage> layersOneByOne(const PinholeCamera& camera, const Mesh& mesh, int layers,
                                          const std::function<bool(size_t)>& isDrawn) {
  Image<std::map<float, Fragment>> byDepth(camera.width(), camera.height());
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!isDrawn(i)) {
      continue;
    }
    const FragmentImage image = rasterize(camera, triangleOf(mesh, i));
    for (size_t pixel = 0; pixel < image.size(); ++pixel) {
      if (image[pixel].covered()) {
        Fragment fragment = image[pixel];
        fragment.triangle = static_cast<uint32_t>(i);
        byDepth[pixel].emplace(fragment.t, fragment);  // keeps the first one of a depth
      }
    }
  }
  std::vector<FragmentImage> images(static_cast<size_t>(layers), FragmentImage(camera.width(), camera.height()));
  for (size_t pixel = 0; pixel < byDepth.size(); ++pixel) {
    size_t layer = 0;
    for (const auto& [z, fragment] : byDepth[pixel]) {
      if (layer < images.size()) {
        images[layer++][pixel] = fragment;
      }
    }
  }
  return images;
}

TEST(RasterizeLayers, agreesWithDrawingTriangleByTriangle) {
  Mesh mesh = test::randomTriangles(250, 7);
  // Some of them twice: the copies coincide.
  const std::vector<glm::uvec3> copies(mesh.triangles.begin(), mesh.triangles.begin() + 40);
  mesh.triangles.insert(mesh.triangles.end(), copies.begin(), copies.end());
  for (const int layers : {1, 2, 5, kMaxLayers}) {
    const std::vector<FragmentImage> images = rasterizeLayers(smallCamera(), mesh, layers);
    const std::vector<FragmentImage> expected =
        layersOneByOne(smallCamera(), mesh, layers, [](size_t) { return true; });
    ASSERT_EQ(images.size(), static_cast<size_t>(layers));
    for (size_t layer = 0; layer < images.size(); ++layer) {
      EXPECT_TRUE(images[layer] == expected[layer]) << "layer " << layer << " of " << layers;
    }
  }
}

TEST(RasterizeLayers, drawsTheSidesThatItIsToldTo) {
  const PinholeCamera camera = smallCamera();
  const Mesh mesh = test::randomTriangles(150, 3);
  std::vector<DrawnSides> sides(mesh.triangles.size());
  for (size_t i = 0; i < sides.size(); ++i) {
    sides[i] = i % 3 == 0 ? DrawnSides::kBoth : i % 3 == 1 ? DrawnSides::kFront : DrawnSides::kBack;
  }
  const auto facesEye = [&](size_t i) {
    const glm::uvec3& t = mesh.triangles[i];
    const glm::vec3 normal =
        glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
    return glm::dot(normal, camera.eye() - mesh.positions[t.x]) > 0;
  };
  const std::vector<FragmentImage> images = rasterizeLayers(camera, mesh, 4, sides);
  const std::vector<FragmentImage> expected = layersOneByOne(camera, mesh, 4, [&](size_t i) {
    return sides[i] == DrawnSides::kBoth || (sides[i] == DrawnSides::kFront) == facesEye(i);
  });
  for (size_t layer = 0; layer < images.size(); ++layer) {
    EXPECT_TRUE(images[layer] == expected[layer]) << "layer " << layer;
  }
}

TEST(RasterizeLayers, wallsOneBehindTheOtherAreLayers) {
  Mesh mesh;
  for (const float z : {-0.5f, 0.5f, 0.0f}) {
    test::addWall(mesh, z, 3);
  }
  const std::vector<FragmentImage> images = rasterizeLayers(smallCamera(), mesh, 4);
  const float depths[] = {9.5f, 10, 10.5f};
  for (size_t pixel = 0; pixel < images[0].size(); ++pixel) {
    for (size_t layer = 0; layer < 3; ++layer) {
      ASSERT_NEAR(images[layer][pixel].t, depths[layer], 1e-5f);
    }
    ASSERT_FALSE(images[3][pixel].covered());
  }
}

TEST(RasterizeLayers, theFirstLayerIsTheImage) {
  const Mesh mesh = test::ballBeforePlane();
  EXPECT_TRUE(rasterizeLayers(smallCamera(), mesh, 3)[0] == rasterize(smallCamera(), mesh));
}

TEST(RasterizeLayers, wallsThroughTheEyePlaneAreClipped) {
  Mesh floor;
  test::addQuad(floor, {-3, -0.5f, 30}, {3, -0.5f, 30}, {3, -0.5f, -3}, {-3, -0.5f, -3});
  const std::vector<FragmentImage> images =
      rasterizeLayers(smallCamera(), floor, 2, {DrawnSides::kFront, DrawnSides::kFront});
  EXPECT_TRUE(images[0] == rasterize(smallCamera(), floor));
  EXPECT_TRUE(images[0](kWidth / 2, kHeight - 1).covered());
  EXPECT_FALSE(images[1](kWidth / 2, kHeight - 1).covered());
}

TEST(RasterizeLayers, sameForAnyNumberOfThreads) {
  const Mesh mesh = test::randomTriangles(9000, 5);
  setThreadCount(1);
  const std::vector<FragmentImage> expected = rasterizeLayers(smallCamera(), mesh, 4);
  for (const int threads : {2, 5}) {
    setThreadCount(threads);
    EXPECT_TRUE(rasterizeLayers(smallCamera(), mesh, 4) == expected) << threads << " threads";
  }
  setThreadCount(0);
}

TEST(RasterizeLayers, nothingToDrawGivesEmptyLayers) {
  for (const FragmentImage& image : rasterizeLayers(smallCamera(), {}, 2)) {
    EXPECT_TRUE(std::none_of(image.begin(), image.end(), [](const Fragment& f) { return f.covered(); }));
  }
}

TEST(RasterizeLayersDeathTest, refusesNoLayersAndTooMany) {
  EXPECT_DEATH(rasterizeLayers(smallCamera(), {}, 0), "layers");
  EXPECT_DEATH(rasterizeLayers(smallCamera(), {}, kMaxLayers + 1), "layers");
}

}  // namespace
}  // namespace ocelli
