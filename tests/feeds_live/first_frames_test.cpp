#include "oc_core/feeds_live/first_frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/feeds_video/video_writer.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(FirstFrames, areOneOfEachFeedOrSayWhyNot) {
  const test::TemporaryFolder folder;
  VideoWriter writer(folder.path() / "a.mkv", 32, 32, {10, 20, true});
  writer.add(Image<Rgb8>(32, 32, Rgb8(11)), 0);
  writer.add(Image<Rgb8>(32, 32, Rgb8(22)), 0.1);
  writer.finish();
  FeedSetup setup;
  setup.feeds.resize(3);
  for (Feed& feed : setup.feeds) {
    feed.source = (folder.path() / "a.mkv").string();
    feed.width = 32;
    feed.height = 32;
  }
  setup.feeds[1].source = "/nowhere/b.mkv";
  setup.feeds[2].width = 64;
  const std::vector<FirstFrame> frames = firstFrames(setup, 5);
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[0].image, Image<Rgb8>(32, 32, Rgb8(11)));
  EXPECT_EQ(frames[0].message, "");
  EXPECT_TRUE(frames[1].image.empty());
  EXPECT_THAT(frames[1].message, testing::HasSubstr("/nowhere/b.mkv"));
  EXPECT_TRUE(frames[2].image.empty());
  EXPECT_THAT(frames[2].message, testing::HasSubstr("32x32 pixels, and the setup says 64x32"));
}

}  // namespace
}  // namespace ocelli
