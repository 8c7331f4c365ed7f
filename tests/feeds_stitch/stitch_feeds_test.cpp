#include "oc_core/feeds_stitch/stitch_feeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace ocelli {
namespace {

/// Rectangles of many sizes and colours, in which features are easily found.
Image<Rgb8> madePlace(int width, int height) {
  Image<Rgb8> image(width, height, Rgb8(120));
  uint32_t seed = 7;
  const auto next = [&](uint32_t below) {
    seed = seed * 1664525u + 1013904223u;
    return static_cast<int>((seed >> 8) % below);
  };
  for (int k = 0; k < 900; ++k) {
    const int left = next(static_cast<uint32_t>(width));
    const int top = next(static_cast<uint32_t>(height));
    const int right = std::min(width, left + 4 + next(28));
    const int bottom = std::min(height, top + 4 + next(28));
    const Rgb8 color(next(256), next(256), next(256));
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        image(x, y) = color;
      }
    }
  }
  return image;
}

template <class Pixel>
Image<Pixel> cutOut(const Image<Pixel>& image, int left, int width) {
  Image<Pixel> part(width, image.height());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < width; ++x) {
      part(x, y) = image(left + x, y);
    }
  }
  return part;
}

TEST(StitchFeeds, JoinsViewsThatOverlap) {
  const Image<Rgb8> place = madePlace(640, 300);
  Image<uint8_t> labels(640, 300);
  for (int y = 100; y < 200; ++y) {
    for (int x = 60; x < 110; ++x) {  // in the left view alone
      labels(x, y) = 3;
    }
  }
  const StitchedFeeds stitched =
      stitchFeeds({cutOut(place, 0, 400), cutOut(place, 240, 400)}, {cutOut(labels, 0, 400), cutOut(labels, 240, 400)});
  ASSERT_EQ(stitched.feeds.size(), 2u);
  EXPECT_GT(stitched.image.width(), 500);
  EXPECT_GT(stitched.seconds, 0);
  ASSERT_EQ(stitched.labels.size(), stitched.owner.size());
  std::array<size_t, 3> owned{};
  size_t labelled = 0;
  for (size_t i = 0; i < stitched.owner.size(); ++i) {
    ASSERT_LE(stitched.owner[i], 2);
    ++owned[stitched.owner[i]];
    if (stitched.labels[i] != 0) {
      EXPECT_EQ(stitched.labels[i], 3);
      EXPECT_EQ(stitched.owner[i], 1);
      ++labelled;
    }
  }
  EXPECT_GT(owned[1], 400u * 300 / 2);
  EXPECT_GT(owned[2], 400u * 300 / 2);
  // 50 by 100, bent a little.
  EXPECT_NEAR(static_cast<double>(labelled), 5000, 1000);
}

TEST(StitchFeeds, MakesNothingOfViewsThatShareNothing) {
  const Image<Rgb8> place = madePlace(1000, 300);
  const Image<uint8_t> none(400, 300);
  EXPECT_TRUE(stitchFeeds({cutOut(place, 0, 400), cutOut(place, 600, 400)}, {none, none}).feeds.empty());
  const Image<Rgb8> plain(400, 300, Rgb8(90));
  EXPECT_TRUE(stitchFeeds({plain, plain}, {none, none}).feeds.empty());
}

}  // namespace
}  // namespace ocelli
