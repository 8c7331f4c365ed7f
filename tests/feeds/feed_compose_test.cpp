#include "oc_core/feeds/feed_compose.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

/// Smooth, and different in each feed.
Image<Rgb8> frameOf(const Feed& feed, int tone) {
  Image<Rgb8> image(feed.width, feed.height);
  for (int y = 0; y < feed.height; ++y) {
    for (int x = 0; x < feed.width; ++x) {
      image(x, y) = Rgb8(x * 200 / feed.width, y * 200 / feed.height, tone);
    }
  }
  return image;
}

struct MadeFeeds {
  FeedGraph graph{test::tSetup()};
  FeedMap map{graph};
  std::vector<Image<Rgb8>> frames;
  std::vector<FeedPicture> pictures;

  MadeFeeds() {
    for (size_t i = 0; i < graph.frusta(); ++i) {
      frames.push_back(frameOf(graph.feedOf(i), 50 + 80 * static_cast<int>(i)));
    }
    for (const Image<Rgb8>& frame : frames) {
      pictures.push_back({&frame});
    }
  }
};

TEST(FeedCompose, samplesBetweenPixelsAsDoublesDo) {
  MadeFeeds feeds;
  Image<Rgb8> image;
  composeFeeds(feeds.map, feeds.pictures, ErasedLook::kBackground, image);
  ASSERT_EQ(image.width(), 320);
  for (int y = 2; y < 240; y += 5) {
    for (int x = 2; x < 320; x += 5) {
      const size_t frustum = feeds.graph.chainAt({x + 0.5, y + 0.5}).back();
      const auto pixel = feeds.graph.feedPixelAt(frustum, {x + 0.5, y + 0.5});
      if (!pixel || pixel->x < 1 || pixel->y < 1 || pixel->x > 639 || pixel->y > 479) {
        continue;
      }
      // The frame is a step function of 3.2 pixels a level; linear to within one level.
      EXPECT_NEAR(image(x, y).x, (pixel->x - 0.5) * 200 / 640, 1.2);
      EXPECT_NEAR(image(x, y).y, (pixel->y - 0.5) * 200 / 480, 1.2);
      EXPECT_EQ(image(x, y).z, 50 + 80 * static_cast<int>(frustum));
    }
  }
}

TEST(FeedCompose, sumsAreThoseOfEachChannel) {
  MadeFeeds feeds;
  for (Image<Rgb8>& frame : feeds.frames) {
    for (size_t i = 0; i < frame.size(); ++i) {
      frame[i] = Rgb8(i * 7919 % 256, i * 104729 % 256, i * 1299709 % 256);
    }
  }
  Image<Rgb8> image;
  composeFeeds(feeds.map, feeds.pictures, ErasedLook::kBackground, image);
  for (size_t pixel = 0; pixel < image.size(); ++pixel) {
    const FeedPlace place = feeds.map.placesAt(pixel).front();
    if (!place.isInFeed()) {
      continue;
    }
    const Image<Rgb8>& frame = feeds.frames[place.frustum];
    const int x = place.x / 256;
    const int y = place.y / 256;
    const int fx = place.x % 256;
    const int fy = place.y % 256;
    const int x1 = std::min(x + 1, frame.width() - 1);
    const int y1 = std::min(y + 1, frame.height() - 1);
    for (int c = 0; c < 3; ++c) {
      const int sum = (frame(x, y)[c] * (256 - fx) + frame(x1, y)[c] * fx) * (256 - fy) +
                      (frame(x, y1)[c] * (256 - fx) + frame(x1, y1)[c] * fx) * fy;
      ASSERT_EQ(image[pixel][c], (sum + 32768) / 65536) << pixel;
    }
  }
}

TEST(FeedCompose, framesAreLit) {
  MadeFeeds feeds;
  Image<Rgb8> plain;
  composeFeeds(feeds.map, feeds.pictures, ErasedLook::kBackground, plain);
  const glm::dvec3 light(1.1, 0.9, 1.7);
  for (FeedPicture& picture : feeds.pictures) {
    picture.frameLight = light;
  }
  Image<Rgb8> lit;
  composeFeeds(feeds.map, feeds.pictures, ErasedLook::kBackground, lit);
  for (size_t i = 0; i < lit.size(); ++i) {
    if (!feeds.map.placesAt(i).front().isInFeed()) {
      continue;
    }
    for (int c = 0; c < 3; ++c) {
      // Both are rounded.
      ASSERT_NEAR(lit[i][c], std::min(255.0, plain[i][c] * light[c]), 0.5 + 0.5 * light[c] + 0.1) << i;
    }
  }
}

TEST(FeedCompose, hatchesWhatNoFeedShows) {
  MadeFeeds feeds;
  feeds.pictures[1].frame = nullptr;
  Image<Rgb8> image;
  composeFeeds(feeds.map, feeds.pictures, ErasedLook::kBackground, image);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      if (feeds.graph.chainAt({x + 0.5, y + 0.5}).back() == 1) {
        EXPECT_TRUE(image(x, y) == Rgb8(40) || image(x, y) == Rgb8(64));
      }
    }
  }
}

TEST(FeedCompose, erasesAndOverlaysByTheMarks) {
  MadeFeeds feeds;
  const Image<Rgb8> still(640, 480, Rgb8(9, 9, 9));
  FeedMarks erased(320, 240, 2);
  erased.cells() = Image<FeedMark>(320, 240, {255, 0});
  FeedMarks shown(320, 240, 2);
  shown.cells() = Image<FeedMark>(320, 240, {0, 255});
  feeds.pictures[1] = {&feeds.frames[1], &still, &erased};
  const int x = 120;
  const int y = 120;
  ASSERT_EQ(feeds.graph.chainAt({x + 0.5, y + 0.5}).back(), 1u);
  Image<Rgb8> image;
  composeFeeds(feeds.map, feeds.pictures, ErasedLook::kBackground, image);
  EXPECT_EQ(image(x, y), Rgb8(9, 9, 9));
  composeFeeds(feeds.map, feeds.pictures, ErasedLook::kRed, image);
  EXPECT_EQ(image(x, y), Rgb8(132, 5, 5));  // half red, half background
  feeds.pictures[1].backgroundLight = {2, 1, 100};
  composeFeeds(feeds.map, feeds.pictures, ErasedLook::kBackground, image);
  EXPECT_EQ(image(x, y), Rgb8(18, 9, 36)) << "in another light, at most 4 times as bright";
  feeds.pictures[0] = {&feeds.frames[0], &still, &shown};
  composeFeeds(feeds.map, feeds.pictures, ErasedLook::kRed, image);
  EXPECT_EQ(image(x, y).z, 50) << "the root's subject stands before the near face";
}

}  // namespace
}  // namespace ocelli
