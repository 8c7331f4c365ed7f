#include "oc_core/ocri/layered_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/layered_depth_image.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

constexpr size_t kLayersJoined = 2 * static_cast<size_t>(kWidth - 1) * (kHeight - 1);

size_t samplesOf(const ReferenceImages& layers) {
  size_t count = 0;
  for (const ReferenceImage& layer : layers) {
    count += layer.sampleCount();
  }
  return count;
}

/// The triangles between samples, not those of squares.
std::vector<std::array<uint32_t, 3>> trianglesAcrossLayers(const Mesh& mesh, size_t samples) {
  std::vector<std::array<uint32_t, 3>> joined;
  for (const glm::uvec3& t : mesh.triangles) {
    if (t.x < samples && t.y < samples && t.z < samples) {
      joined.push_back({t.x, t.y, t.z});
    }
  }
  std::sort(joined.begin(), joined.end());
  return joined;
}

MissingSamples missingFrom(const Mesh& mesh, const Mesh& scene) {
  MissingSamples missing;
  for (const View& view : ViewCell{}.edgeViews(View{})) {
    const PinholeCamera camera(view, kWidth, kHeight);
    missing += countMissing(compareFrames(camera, positionImage(camera, scene), positionImage(camera, mesh)));
  }
  return missing;
}

TEST(LayeredMesh, aSingleLayerIsJoinedLikeADepthImage) {
  for (const Mesh& scene :
       {test::wall(0), test::tiltedPlane(9, 60), test::boxBeforeWall(), test::ballBeforePlane(), makeTorus(0.4f, 40)}) {
    const ReferenceImage image = buildDepthImage(smallCamera(), scene);
    const Mesh mesh = layeredMesh({image});
    const Mesh expected = imageMesh(image);
    EXPECT_EQ(trianglesAcrossLayers(mesh, image.sampleCount()), trianglesAcrossLayers(expected, image.sampleCount()));
    EXPECT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.begin() + static_cast<long>(image.sampleCount()),
                           expected.positions.begin()));
    EXPECT_GE(mesh.triangles.size(), expected.triangles.size());
  }
}

TEST(LayeredMesh, aWallGoesOnBehindABox) {
  const ReferenceImages layers = buildLayeredDepthImage(smallCamera(), test::boxBeforeWall(), 2);
  const Mesh mesh = layeredMesh(layers);
  size_t onWall = 0;
  for (const auto& t : trianglesAcrossLayers(mesh, samplesOf(layers))) {
    const auto isWall = [&](uint32_t vertex) { return mesh.positions[vertex].z < -0.5f; };
    EXPECT_TRUE(isWall(t[0]) == isWall(t[1]) && isWall(t[1]) == isWall(t[2]));
    onWall += isWall(t[0]);
  }
  EXPECT_EQ(onWall, kLayersJoined) << "the wall fills the image, and is one surface";
}

// Two parallel planes that rise by more from pixel to pixel than they lie apart: the nearest sample of the next pixel
// is the one of the wrong plane.
TEST(LayeredMesh, parallelSheetsAreNotMixedUp) {
  constexpr float kSteepness = 9;
  const float footprint = 10 / smallCamera().focalPixels();
  const float apart = kSteepness * footprint * 0.9f;
  Mesh sheets = test::tiltedPlane(kSteepness, 60);
  append(sheets, test::tiltedPlane(kSteepness, 60), glm::translate(glm::mat4(1), glm::vec3(0, 0, -apart)));
  const ReferenceImages layers = buildLayeredDepthImage(smallCamera(), sheets, 2);
  const Mesh mesh = layeredMesh(layers);
  const auto isBehind = [&](uint32_t vertex) {
    const glm::vec3& p = mesh.positions[vertex];
    return p.z + kSteepness * p.y < -apart / 2;
  };
  const auto joined = trianglesAcrossLayers(mesh, samplesOf(layers));
  EXPECT_EQ(joined.size(), 2 * kLayersJoined);
  for (const auto& t : joined) {
    EXPECT_TRUE(isBehind(t[0]) == isBehind(t[1]) && isBehind(t[1]) == isBehind(t[2]));
  }
}

TEST(LayeredMesh, missesLessThanTheDepthImageAndThanUnjoinedLayers) {
  const Mesh scene = test::boxBeforeWall(0.9f);
  const ReferenceImages layers = buildLayeredDepthImage(smallCamera(), scene, 2);
  const MissingSamples layered = missingFrom(layeredMesh(layers), scene);
  const MissingSamples image = missingFrom(imageMesh(layers[0]), scene);
  EXPECT_GT(image.strict, 1000u);
  // What is left are the flanks of the box, which the reference view does not see.
  EXPECT_LT(layered.strict, image.strict / 2);
  EXPECT_EQ(layered.thick, 0u);
}

TEST(LayeredMesh, everySampleIsAVertexInPixelOrder) {
  const ReferenceImages layers = buildLayeredDepthImage(smallCamera(), test::ballBeforePlane(), 2);
  ASSERT_EQ(layers.size(), 2u);
  const Mesh mesh = layeredMesh(layers);
  size_t vertex = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const ReferenceImage& layer : layers) {
        if (layer.holds(x, y)) {
          EXPECT_EQ(mesh.positions[vertex], *smallCamera().unproject(layer.undistorted(x, y)));
          EXPECT_EQ(mesh.colors[vertex++], layer.color(x, y));
        }
      }
    }
  }
  EXPECT_EQ(vertex, samplesOf(layers));
  EXPECT_EQ(mesh.colors.size(), mesh.positions.size());
}

TEST(LayeredMesh, sameForAnyNumberOfThreads) {
  const ReferenceImages layers = buildLayeredDepthImage(smallCamera(), test::randomTriangles(400, 11), kMaxLayers);
  setThreadCount(1);
  const Mesh expected = layeredMesh(layers);
  for (const int threads : {2, 5}) {
    setThreadCount(threads);
    const Mesh mesh = layeredMesh(layers);
    EXPECT_TRUE(test::sameBytes(mesh.positions, expected.positions));
    EXPECT_TRUE(test::sameBytes(mesh.triangles, expected.triangles));
  }
  setThreadCount(0);
}

TEST(LayeredMesh, nothingGivesAnEmptyMesh) {
  EXPECT_TRUE(layeredMesh({}).empty());
  EXPECT_TRUE(layeredMesh(buildLayeredDepthImage(smallCamera(), {}, 2)).empty());
}

TEST(LayeredMeshDeathTest, refusesLayersOfDifferentViews) {
  View moved;
  moved.eye.x += 1;
  const ReferenceImage here = buildDepthImage(smallCamera(), test::wall(0));
  const ReferenceImage there = buildDepthImage(PinholeCamera(moved, kWidth, kHeight), test::wall(0));
  EXPECT_DEATH(layeredMesh({here, there}), "one view");
}

}  // namespace
}  // namespace ocelli
