// A video of a street as Debian has it, which nobody made for this program.
#include <gtest/gtest.h>

#include <filesystem>

#include "oc_core/feeds_live/feeds_run.h"

namespace ocelli {
namespace {

TEST(FeedsRun, takesAStrangersVideo) {
  const std::filesystem::path video = "/usr/share/doc/opencv-doc/examples/data/vtest.avi";
  if (!std::filesystem::exists(video)) {
    GTEST_SKIP() << "the package opencv-doc is not installed";
  }
  FeedSetup setup;
  Feed feed;
  feed.name = "street";
  feed.source = video.string();
  feed.width = 768;
  feed.height = 576;
  feed.lens = {{800, 800}, {384, 288}, 0, 0, 0, 0, 0};
  feed.pose = {{0, 6, 12}, {0, 0, 0}, {0, 1, 0}};
  setup.feeds = {feed};
  setup.frusta = {{"street", "", {}}};
  setup.output = {768, 576, 39, {0, 0, 0}};
  FeedsRunOptions options;
  options.framesPerSecond = 10;
  options.seconds = 6;
  size_t frames = 0;
  size_t withSubjects = 0;
  Image<Rgb8> last;
  size_t changes = 0;
  const FeedsRunFigures figures = runFeeds(setup, options, [&](const ComposedFrame& frame) {
    ++frames;
    withSubjects += frame.composer.subjects().count() > 0 ? 1 : 0;
    changes += !(frame.image == last);
    last = frame.image;
  });
  EXPECT_EQ(frames, 60u);
  EXPECT_EQ(changes, frames) << "people walk all the time";
  EXPECT_EQ(figures.feeds[0].state, FeedState::kLive);
  EXPECT_GE(figures.feeds[0].framesRead, 58u);
  // It learns its background first.
  EXPECT_GT(withSubjects, 20u);
}

}  // namespace
}  // namespace ocelli
