#include <gtest/gtest.h>

#include "oc_core/depth_rays/sample_pyramid.h"
#include "tests/depth_rays/sampled_scenes.h"

namespace ocelli {
namespace {

/// Pixels of a pinhole anywhere around the scene, wide or narrow.
RayBlock randomBlock(Random& random) {
  const auto point = [&](float half) {
    return glm::vec3(random.inRange(-half, half), random.inRange(-half, half), random.inRange(-half, half));
  };
  RayBlock block;
  block.origin = point(random.below(2) == 0 ? 1.0f : 4.0f);
  glm::vec3 forward = point(1) - block.origin;
  if (random.below(4) == 0) {
    forward = {0, 0, -1};  // directions of both signs along two axes
  }
  forward = glm::normalize(forward);
  const float pixel = random.below(2) == 0 ? 0.002f : 0.05f;
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0.1f, 1, 0.2f)));
  block.columns = 1 + static_cast<int>(random.below(RayBlock::kMaxSide));
  block.rows = 1 + static_cast<int>(random.below(RayBlock::kMaxSide));
  block.perColumn = right * pixel;
  block.perRow = glm::cross(forward, right) * pixel;
  block.first = forward + block.perColumn * random.inRange(-8, 8) + block.perRow * random.inRange(-8, 8);
  block.reach.fill(random.below(3) == 0 ? 5.0f : 100.0f);
  block.meets.fill(false);
  return block;
}

// Each ray of a block meets what it meets by itself when every triangle is tested: bit by bit.
TEST(PyramidBlock, meetsWhatEachRayMeets) {
  const Mesh mesh = test::thingsBeforeWall();
  test::forEachSampledScene(mesh, PinholeCamera({}, 30, 20),
                            [&](const std::string& name, const ReferenceImages& images) {
                              const SampleCells cells = sampleCells(images);
                              const SamplePyramid pyramid(cells);
                              Random random(11);
                              size_t met = 0;
                              for (int i = 0; i < 60; ++i) {
                                RayBlock block = randomBlock(random);
                                const RayBlock before = block;
                                RayCost cost;
                                pyramid.meetBlock(block, cost);
                                RayBlock wide = before;
                                RayCost costOfWide;
                                pyramid.meetWideBlock(wide, costOfWide);
                                EXPECT_LE(costOfWide.steps(), (RayBlock::kMaxRays + 1) * pyramid.maxSteps()) << name;
                                EXPECT_LE(cost.steps(), pyramid.maxSteps()) << name;
                                for (int row = 0; row < block.rows; ++row) {
                                  for (int column = 0; column < block.columns; ++column) {
                                    const auto slow = meetEveryCell(cells, before.ray(column, row));
                                    const auto at = static_cast<size_t>(block.indexOf(column, row));
                                    ASSERT_EQ(block.meets[at], slow.has_value()) << name;
                                    ASSERT_EQ(wide.meets[at], slow.has_value()) << name;
                                    if (slow) {
                                      ++met;
                                      EXPECT_EQ(block.meeting[at].share, slow->share) << name;
                                      EXPECT_EQ(block.meeting[at].triangle, slow->triangle) << name;
                                      EXPECT_EQ(wide.meeting[at].share, slow->share) << name;
                                      EXPECT_EQ(wide.meeting[at].triangle, slow->triangle) << name;
                                    }
                                  }
                                }
                              }
                              EXPECT_GT(met, 100u) << name;
                            });
}

// What lies before the reach of a ray alone counts, as where something nearer has been drawn.
TEST(PyramidBlock, keepsNearerMeetings) {
  const ReferenceImages images{buildDepthImage(PinholeCamera({}, 30, 20), test::thingsBeforeWall())};
  const SampleCells cells = sampleCells(images);
  const SamplePyramid pyramid(cells);
  RayBlock block;
  block.origin = {0, 0, 10};
  block.first = {0, 0, -1};
  block.perColumn = {0.005f, 0, 0};
  block.perRow = {0, -0.005f, 0};
  block.columns = 2;
  block.rows = 1;
  block.reach = {};
  block.reach[0] = 2;
  block.reach[1] = 100;
  block.meets.fill(false);
  block.meets[0] = true;
  block.meeting[0] = {2, 12345, 0, 0};
  RayCost cost;
  pyramid.meetBlock(block, cost);
  EXPECT_EQ(block.meeting[0].triangle, 12345u);
  EXPECT_EQ(block.reach[0], 2);
  ASSERT_TRUE(block.meets[1]);
  EXPECT_NEAR(block.meeting[1].share, static_cast<double>(block.reach[1]), 1e-5);
}

TEST(PyramidBlock, nothingIsMetOfNothing) {
  const SampleCells cells = sampleCells({});
  const SamplePyramid pyramid(cells);
  Random random(1);
  RayBlock block = randomBlock(random);
  RayCost cost;
  pyramid.meetBlock(block, cost);
  pyramid.meetWideBlock(block, cost);
  EXPECT_EQ(cost.steps(), 0u);
  EXPECT_FALSE(block.meets[0]);
}

}  // namespace
}  // namespace ocelli
