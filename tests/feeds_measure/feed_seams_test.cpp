#include "oc_core/feeds_measure/feed_seams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "oc_core/feeds_measure/feed_rigs.h"

namespace ocelli {
namespace {

/// Which frustum each pixel shows, asked of the graph itself.
Image<int> shownFrusta(const FeedGraph& graph) {
  Image<int> shown(graph.camera().width(), graph.camera().height());
  for (int y = 0; y < shown.height(); ++y) {
    for (int x = 0; x < shown.width(); ++x) {
      shown(x, y) = static_cast<int>(graph.chainAt({x + 0.5, y + 0.5}).back());
    }
  }
  return shown;
}

Image<Rgb8> madePicture(int width, int height, uint32_t seed) {
  Image<Rgb8> image(width, height);
  for (size_t i = 0; i < image.size(); ++i) {
    seed = seed * 1664525u + 1013904223u;
    image[i] = Rgb8(60 + (seed >> 24) % 90, 60 + (seed >> 16) % 90, 60 + (seed >> 8) % 90);
  }
  return image;
}

class FeedSeamsOfAT : public testing::Test {
 protected:
  FeedGraph graph{resizedSetup(corridorTRig().setup(), 160, 120)};
  SeamMeter meter{FeedMap(graph)};
};

TEST_F(FeedSeamsOfAT, WhatIsTheSameHasNone) {
  const Image<Rgb8> image = madePicture(160, 120, 1);
  const FeedSeams seams = meter.measure(image, image);
  EXPECT_GT(seams.pairs, 100u);
  EXPECT_EQ(seams.levels, 0);
  EXPECT_EQ(seams.insideLevels, 0);
  EXPECT_EQ(seams.visible, 0u);
}

TEST_F(FeedSeamsOfAT, AFeedThatIsBrighterJumpsBySoMuch) {
  const Image<int> shown = shownFrusta(graph);
  const Image<Rgb8> rendered(160, 120, Rgb8(100));
  for (const int brighter : {10, 30}) {
    Image<Rgb8> composed = rendered;
    for (size_t i = 0; i < composed.size(); ++i) {
      composed[i] += Rgb8(static_cast<uint8_t>(shown[i] == 0 ? brighter : 0));
    }
    const FeedSeams seams = meter.measure(composed, rendered);
    // The root meets both branches; these meet each other in the middle, without a jump.
    EXPECT_GT(seams.levels, 0.5 * brighter);
    EXPECT_LE(seams.levels, brighter);
    EXPECT_EQ(seams.insideLevels, 0);
    EXPECT_EQ(seams.visible > 0, brighter > kSeamLevels);
  }
}

/// All pairs of neighbours by hand.
TEST_F(FeedSeamsOfAT, IsTheExcessOfAllPairsOfNeighbours) {
  const Image<int> shown = shownFrusta(graph);
  const Image<Rgb8> composed = madePicture(160, 120, 2);
  const Image<Rgb8> rendered = madePicture(160, 120, 3);
  const auto jump = [](const Image<Rgb8>& image, int x, int y, int x2, int y2) {
    const glm::ivec3 d = glm::abs(glm::ivec3(image(x, y)) - glm::ivec3(image(x2, y2)));
    return std::max({d.x, d.y, d.z});
  };
  double sum = 0;
  size_t pairs = 0;
  size_t visible = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}}) {
        if (x + dx < 160 && y + dy < 120 && shown(x, y) != shown(x + dx, y + dy)) {
          const int excess = jump(composed, x, y, x + dx, y + dy) - jump(rendered, x, y, x + dx, y + dy);
          ++pairs;
          sum += std::max(0, excess);
          visible += excess > kSeamLevels;
        }
      }
    }
  }
  const FeedSeams seams = meter.measure(composed, rendered);
  EXPECT_EQ(seams.pairs, pairs);
  EXPECT_EQ(seams.visible, visible);
  EXPECT_NEAR(seams.levels, sum / static_cast<double>(pairs), 1e-9);
}

TEST(FeedSeams, MeanOfFrames) {
  const FeedSeams mean = meanSeams({{10, 1, 4, 1}, {10, 3, 6, 3}});
  EXPECT_EQ(mean.levels, 5);
  EXPECT_EQ(mean.insideLevels, 2);
  EXPECT_EQ(mean.visibleShare(), 0.2);
  EXPECT_EQ(meanSeams({}).visibleShare(), 0);
}

}  // namespace
}  // namespace ocelli
