// A block that moves before a pattern, under noise and a light that changes.
#include "oc_core/feeds_background/feed_background.h"

#include <gtest/gtest.h>

#include "oc_core/base/random_numbers.h"
#include "oc_core/feeds_background/picture_text.h"

namespace ocelli {
namespace {

constexpr int kWide = 160;
constexpr int kHigh = 120;

Image<Rgb8> scene(double light, int blockX, uint64_t seed) {
  RandomNumbers random(seed);
  Image<Rgb8> image(kWide, kHigh);
  for (int y = 0; y < kHigh; ++y) {
    for (int x = 0; x < kWide; ++x) {
      const bool isBlock = blockX >= 0 && x >= blockX && x < blockX + 20 && y >= 40 && y < 100;
      const glm::dvec3 color = isBlock ? glm::dvec3(200, 60, 40) : glm::dvec3(90 + x / 2, 100 + (y / 10 % 2) * 40, 110);
      for (int c = 0; c < 3; ++c) {
        image(x, y)[c] =
            static_cast<uint8_t>(std::clamp(color[c] * light + (seed == 0 ? 0 : 2 * random.normal()), 0.0, 255.0));
      }
    }
  }
  return image;
}

TEST(FeedBackground, findsABlockWhateverTheLight) {
  FeedBackground background(kWide, kHigh, scene(1, -1, 0));
  for (int k = 0; k < 20; ++k) {
    const double light = 1 + 0.15 * std::sin(0.5 * k);
    const FeedBlobs blobs = background.update(scene(light, 20 + 4 * k, static_cast<uint64_t>(k + 1)));
    ASSERT_EQ(blobs.blobs.size(), 1u) << k;
    const SubjectBlob& blob = blobs.blobs[0];
    // Masks have two pixels of the feed; opening and closing move a border by one or two of those.
    EXPECT_NEAR(blob.foot.x, 30 + 4 * k, 4);
    EXPECT_NEAR(blob.foot.y, 100, 4);
    EXPECT_NEAR(blob.lower.y, 40, 6);
    EXPECT_FALSE(blob.isCutBelow);
    // The background has the light of the frame.
    const Rgb8 still = background.image()(10, 105);
    EXPECT_NEAR(still.x * background.light().x, 95 * light, 4);
  }
}

TEST(FeedBackground, findsNothingWhereNothingIs) {
  FeedBackground background(kWide, kHigh, scene(1, -1, 0));
  for (int k = 0; k < 30; ++k) {
    EXPECT_TRUE(background.update(scene(1 + 0.1 * std::sin(0.3 * k), -1, static_cast<uint64_t>(k + 1))).blobs.empty());
  }
}

TEST(FeedBackground, aHandBeforeTheCameraIsNoSubject) {
  FeedBackground background(kWide, kHigh, scene(1, -1, 0));
  for (uint64_t k = 1; k < 10; ++k) {
    background.update(scene(1, 30, k));
    EXPECT_FALSE(background.isCovered());
  }
  for (const Rgb8& hand : {Rgb8(12, 8, 6), Rgb8(190, 150, 130)}) {
    for (int k = 0; k < 60; ++k) {
      EXPECT_TRUE(background.update(Image<Rgb8>(kWide, kHigh, hand)).blobs.empty());
      EXPECT_EQ(background.isCovered(), k >= 4) << k;
    }
    EXPECT_EQ(background.update(scene(1, 60, 99)).blobs.size(), 1u) << "and the place is still known";
    EXPECT_FALSE(background.isCovered());
  }
}

TEST(FeedBackground, learnsWhatItIsNotTold) {
  FeedBackground background(kWide, kHigh, {});
  for (int k = 0; k < 40; ++k) {
    background.update(scene(1, -1, static_cast<uint64_t>(k + 1)));
  }
  const FeedBlobs blobs = background.update(scene(1, 60, 99));
  ASSERT_EQ(blobs.blobs.size(), 1u);
  EXPECT_NEAR(blobs.blobs[0].foot.x, 70, 4);
  EXPECT_NEAR(background.image()(70, 70).x * background.light().x, 90 + 35, 8) << "behind the block";
}

TEST(PictureText, drawsAQuestionMarkForEachLetterThatItLacks) {
  const auto drawn = [](const std::string& text) {
    Image<Rgb8> image(200, 40);
    drawPictureText(image, text, {4, 30}, 20, Rgb8(255));
    return image;
  };
  EXPECT_EQ(drawn("T\u00fcr\x1b"), drawn("T?r?"));
  EXPECT_NE(drawn("T\u00fcr"), drawn("Tr"));
}

}  // namespace
}  // namespace ocelli
