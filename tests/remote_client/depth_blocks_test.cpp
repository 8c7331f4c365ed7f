#include "oc_core/remote/client/depth_blocks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/remote/client/image_cover.h"
#include "oc_core/render/rasterize.h"
#include "tests/remote_client/client_scenes.h"

namespace ocelli {
namespace {

DepthBlocks blocksOf(const ReferenceImage& image) {
  const DepthSpan span = depthSpanOf(image);
  return {image, GpcMap(image.layout, image.width(), image.height()), blockTolerance(span.nearZ, span.farZ)};
}

/// A slanted wall: z of the world grows to the right.
Mesh slantedWall() {
  Mesh mesh;
  for (const glm::vec2& corner : {glm::vec2(-8, -8), glm::vec2(8, -8), glm::vec2(8, 8), glm::vec2(-8, 8)}) {
    mesh.positions.emplace_back(corner, 0.3f * corner.x);
    mesh.colors.emplace_back(0.5f);
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// 1/z of a plane is linear in the pinhole's image: the largest blocks hold it, and their depths are exact from
// anywhere.
TEST(DepthBlocks, holdAPlaneInTheLargestBlocks) {
  const Mesh wall = slantedWall();
  const ReferenceImage image = clientImage(clientView(20), {320, 160}, clientLayout(2), wall);
  const DepthBlocks blocks = blocksOf(image);
  EXPECT_EQ(blocks.size(), 20u * 10u);
  const PinholeCamera camera(movedEye(clientView(14), {0.5f, -0.2f, 0.4f}), 160, 80);
  const Image<float> inverse = blocks.inverseDepth(camera);
  const FragmentImage truth = rasterize(camera, wall);
  for (size_t i = 0; i < inverse.size(); ++i) {
    ASSERT_TRUE(truth[i].covered());
    ASSERT_NEAR(inverse[i] * truth[i].t, 1, 1e-4) << i;
  }
}

// Within what is covered, no surface may move by more than a fraction of a pixel.
TEST(DepthBlocks, areNearTheDepthsOfTheScene) {
  const ReferenceImage image = clientImage(clientView(14), {640, 360}, clientLayout(2));
  const DepthBlocks blocks = blocksOf(image);
  const PinholeCamera camera(movedEye(clientView(11), {0.3f, 0.1f, 0}), 640, 360);
  const Image<float> inverse = blocks.inverseDepth(camera);
  const FragmentImage truth = rasterize(camera, clientStatues());
  size_t seen = 0;
  size_t near = 0;
  for (size_t i = 0; i < inverse.size(); ++i) {
    seen += truth[i].covered();
    near += truth[i].covered() && std::abs(inverse[i] * truth[i].t - 1) < 0.005f;
  }
  // The rest was hidden, or lies at rims.
  EXPECT_GE(static_cast<double>(near), 0.95 * static_cast<double>(seen));
  EXPECT_LE(blocks.size(), image.sampleCount() / 3);
}

TEST(DepthBlocks, leaveOutWhatTheImageDoesNotHold) {
  const ReferenceImage image = clientImage(clientView(14), {320, 180}, clientLayout(2));
  const PinholeCamera camera(clientView(14), 320, 180);
  const Image<float> inverse = blocksOf(image).inverseDepth(camera);
  const FragmentImage truth = rasterize(camera, clientStatues());
  size_t wrong = 0;
  for (size_t i = 0; i < inverse.size(); ++i) {
    wrong += (inverse[i] > 0) != truth[i].covered();
  }
  // Rims, where samples of the image and pixels of the view are not at the same places.
  EXPECT_LE(static_cast<double>(wrong), 0.02 * static_cast<double>(inverse.size()));
}

}  // namespace
}  // namespace ocelli
