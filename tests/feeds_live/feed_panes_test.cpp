#include "oc_core/feeds_live/feed_panes.h"

#include <gtest/gtest.h>

#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

bool overlap(const FeedPane& a, const FeedPane& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height && b.top < a.top + a.height;
}

TEST(FeedPanes, KeepTheirShapesAndApart) {
  for (const FeedSetup& setup : {test::tSetup(), test::chainSetup()}) {
    for (const auto& [width, height] : {std::pair{640, 480}, {1280, 300}, {61, 33}}) {
      const std::vector<FeedPane> panes = feedPanes(setup, width, height);
      ASSERT_EQ(panes.size(), setup.frusta.size());
      for (size_t i = 0; i < panes.size(); ++i) {
        const FeedPane& pane = panes[i];
        EXPECT_GE(pane.left, 0);
        EXPECT_GE(pane.top, 0);
        EXPECT_LE(pane.left + pane.width, width);
        EXPECT_LE(pane.top + pane.height, height);
        EXPECT_NEAR(static_cast<double>(pane.width) / pane.height, 640.0 / 480, 0.1);  // whole pixels, of 12 rows
        for (size_t j = 0; j < i; ++j) {
          EXPECT_FALSE(overlap(pane, panes[j]));
        }
      }
    }
  }
}

TEST(FeedPanes, AreAsLargeAsTheImageLetsThem) {
  const std::vector<FeedPane> square = feedPanes(test::chainSetup(), 640, 480);
  EXPECT_EQ(square[0].top, square[1].top);
  EXPECT_EQ(square[0].left, square[2].left) << "two rows of two";
  const std::vector<FeedPane> wide = feedPanes(test::tSetup(), 1280, 300);
  EXPECT_EQ(wide[0].top, wide[2].top) << "one row of three";
  EXPECT_EQ(wide[0].height, 300);
}

TEST(FeedPanes, ShowTheMeanOfWhatAPixelCovers) {
  FeedSetup setup = test::tSetup();
  setup.output.width = 320;
  setup.output.height = 240;
  const FeedGraph graph(setup);
  FeedComposer composer(graph);
  std::vector<Image<Rgb8>> frames(setup.feeds.size());
  const auto stem = static_cast<size_t>(setup.feedIndex("stem"));
  frames[stem] = Image<Rgb8>(setup.feeds[stem].width, setup.feeds[stem].height);
  for (int y = 0; y < frames[stem].height(); ++y) {
    for (int x = 0; x < frames[stem].width(); ++x) {
      frames[stem](x, y) = Rgb8(x % 200, y % 200, (x + y) % 50);
    }
  }
  const Image<Rgb8> given = frames[stem];
  composer.take(frames);
  Image<Rgb8> image;
  drawFeedPanes(composer, {}, image);
  const FeedPane pane = feedPanes(setup, 320, 240)[0];
  for (const auto& [x, y] : {std::pair{0, 0}, {17, 40}, {pane.width - 1, pane.height - 1}}) {
    const int left = x * given.width() / pane.width;
    const int right = (x + 1) * given.width() / pane.width;
    const int top = y * given.height() / pane.height;
    const int bottom = (y + 1) * given.height() / pane.height;
    glm::dvec3 sum(0);
    for (int v = top; v < bottom; ++v) {
      for (int u = left; u < right; ++u) {
        sum += glm::dvec3(given(u, v));
      }
    }
    sum /= (right - left) * (bottom - top);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(image(pane.left + x, pane.top + y)[c], sum[c], 0.51) << x << " " << y;
    }
  }
  const FeedPane other = feedPanes(setup, 320, 240)[1];
  EXPECT_EQ(image(other.left, other.top), Rgb8(64)) << "no frame yet";
  // Labels are drawn into each pane.
  Image<Rgb8> labelled;
  drawFeedPanes(composer, std::vector<FeedLabel>(3), labelled);
  EXPECT_FALSE(labelled == image);
}

}  // namespace
}  // namespace ocelli
