// Videos as other programs write them, and names that look like addresses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/feeds_video/video_reader.h"
#include "oc_core/feeds_video/video_writer.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

void writeTones(const std::filesystem::path& path, int width, int height, int frames) {
  VideoWriter writer(path, width, height, {25, 20, false});
  for (int k = 0; k < frames; ++k) {
    writer.add(Image<Rgb8>(width, height, Rgb8(static_cast<uint8_t>(20 * k))), k / 25.0);
  }
  writer.finish();
}

/// Runs FFmpeg's program, which writes `path`.
void runFfmpeg(const std::string& arguments, const std::filesystem::path& path) {
  const std::string line = "ffmpeg -v error " + arguments + " " + path.string() + " </dev/null";
  EXPECT_EQ(std::system(line.c_str()), 0) << line;  // NOLINT: in this test alone
}

TEST(StrangeVideo, withoutTimestampsFramesFollowOneAnother) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.h264";  // no container: no timestamps
  runFfmpeg("-f lavfi -i testsrc=rate=10:size=64x48:duration=1 -c:v libx264", path);
  const std::atomic<bool> stop{false};
  VideoReader reader({path.string()}, 5, stop);
  std::vector<double> times;
  for (VideoFrame frame; reader.next(frame);) {
    times.push_back(frame.seconds);
  }
  ASSERT_EQ(times.size(), 10u);
  for (size_t k = 1; k < times.size(); ++k) {
    EXPECT_NEAR(times[k] - times[k - 1], 0.1, 1e-6) << "frame " << k;
  }
}

TEST(StrangeVideo, aFrameWhoseImageWasMovedAwayIsFilledAnew) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.mkv";
  writeTones(path, 64, 48, 3);
  const std::atomic<bool> stop{false};
  VideoReader reader({path.string()}, 5, stop);
  std::vector<Image<Rgb8>> images;
  for (VideoFrame frame; reader.next(frame);) {
    images.push_back(std::move(frame.image));
    ASSERT_EQ(images.back().size(), 64u * 48u);
  }
  EXPECT_EQ(images.size(), 3u);
}

TEST(StrangeVideo, aChangeOfTheSizeIsAnError) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "both.h264";
  writeTones(folder.path() / "large.h264", 64, 48, 5);
  writeTones(folder.path() / "small.h264", 32, 32, 5);
  std::ofstream(path, std::ios::binary) << readFile(folder.path() / "large.h264")
                                        << readFile(folder.path() / "small.h264");
  const std::atomic<bool> stop{false};
  VideoReader reader({path.string()}, 5, stop);
  // FFmpeg looks ahead as it opens a video: which of both sizes is its own is not said for one as short as this.
  try {
    for (VideoFrame frame; reader.next(frame);) {
      ASSERT_EQ(frame.image.width(), reader.width());
      ASSERT_EQ(frame.image.height(), reader.height());
    }
    FAIL() << "the change was not said";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("the pictures of the feed change from"));
  }
}

/// The colour of the middle of the first frame of a video in which FFmpeg's program codes 200, 60, 40 as it is told.
glm::ivec3 colorCoded(const std::string& how) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.mkv";
  runFfmpeg("-f lavfi -i color=0xC83C28:s=64x48:d=0.2 -vf scale=" + how + " -c:v libx264 -qp 4", path);
  const std::atomic<bool> stop{false};
  VideoReader reader({path.string()}, 5, stop);
  VideoFrame frame;
  EXPECT_TRUE(reader.next(frame));
  return frame.image(32, 24);
}

TEST(StrangeVideo, coloursAreThoseThatItSays) {
  const glm::ivec3 wanted(200, 60, 40);
  for (const char* how : {"out_color_matrix=bt601,format=yuv420p -colorspace smpte170m",
                          "out_color_matrix=bt709,format=yuv420p -colorspace bt709",
                          "out_color_matrix=bt709:out_range=full,format=yuv420p -colorspace bt709 -color_range pc"}) {
    const glm::ivec3 got = colorCoded(how);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(got[c], wanted[c], 3) << how;  // levels: rounding of YUV, and of the codec
    }
  }
}

TEST(StrangeVideo, aColonInTheNameBeginsNoAddress) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "left: 1 %d.mkv";
  writeTones(path, 64, 48, 3);
  // As a user's shell names it: without a folder before it.
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  writeTones("right: 2.mkv", 64, 48, 3);
  const std::atomic<bool> stop{false};
  EXPECT_EQ(VideoReader({"left: 1 %d.mkv"}, 5, stop).width(), 64);
  EXPECT_EQ(VideoReader({"right: 2.mkv"}, 5, stop).width(), 64);
  std::filesystem::current_path(before);
}

TEST(StrangeVideo, anEarlierVideoStaysUntilTheNewOneIsComplete) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.mp4";
  std::ofstream(path) << "earlier";
  {
    VideoWriter writer(path, 64, 48, {});
    writer.add(Image<Rgb8>(64, 48, Rgb8(9)), 0);
    EXPECT_EQ(readFile(path), "earlier");
  }
  EXPECT_EQ(readFile(path), "earlier") << "it was not finished";
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.mp4.partial"));
  writeTones(path, 64, 48, 3);
  EXPECT_NE(readFile(path), "earlier");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.mp4.partial"));
}

TEST(StrangeVideo, anEndingWithoutAContainerIsSaid) {
  const test::TemporaryFolder folder;
  try {
    const VideoWriter writer(folder.path() / "a.txt", 64, 48, {});
    FAIL() << "it was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("videos do not end in \".txt\""));
  }
}

}  // namespace
}  // namespace ocelli
