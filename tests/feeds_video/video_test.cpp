// Videos come back as they were written, and readers end in time.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <thread>

#include "oc_core/base/error.h"
#include "oc_core/feeds_video/video_reader.h"
#include "oc_core/feeds_video/video_writer.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

Image<Rgb8> toneAt(int k) {
  Image<Rgb8> image(64, 48);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      image(x, y) = Rgb8(4 * x, 5 * y, 10 * k);
    }
  }
  return image;
}

std::vector<VideoFrame> framesOf(const std::filesystem::path& path) {
  const std::atomic<bool> stop{false};
  VideoReader reader({path.string()}, 5, stop);
  EXPECT_EQ(reader.width(), 64);
  EXPECT_EQ(reader.height(), 48);
  std::vector<VideoFrame> frames;
  for (VideoFrame frame; reader.next(frame);) {
    frames.push_back(frame);
  }
  return frames;
}

TEST(Video, losslessComesBackWithItsTimestamps) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.mkv";
  VideoWriter writer(path, 64, 48, {30, 20, true});
  const std::vector<double> times{0.25, 0.2833, 0.4, 1.5};  // uneven, as of lost frames
  for (size_t k = 0; k < times.size(); ++k) {
    writer.add(toneAt(static_cast<int>(k)), times[k]);
  }
  writer.finish();
  const auto frames = framesOf(path);
  ASSERT_EQ(frames.size(), times.size());
  for (size_t k = 0; k < times.size(); ++k) {
    EXPECT_NEAR(frames[k].seconds, times[k], 6e-4);  // Matroska has milliseconds
    EXPECT_EQ(frames[k].image, toneAt(static_cast<int>(k)));
  }
}

TEST(Video, h264IsNear) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.mp4";
  VideoWriter writer(path, 64, 48, {25, 12, false});
  for (int k = 0; k < 5; ++k) {
    writer.add(toneAt(k), k / 25.0);
  }
  writer.finish();
  const auto frames = framesOf(path);
  ASSERT_EQ(frames.size(), 5u);
  EXPECT_NEAR(frames[3].seconds, 0.12, 1e-4);
  double sum = 0;
  for (size_t i = 0; i < frames[3].image.size(); ++i) {
    sum += std::abs(frames[3].image[i].y - toneAt(3)[i].y);
  }
  EXPECT_LT(sum / 3072, 4);  // levels: of rate factor 12 and colour at half the resolution
}

TEST(Video, namesWhatIsNoVideo) {
  const test::TemporaryFolder folder;
  const std::atomic<bool> stop{false};
  EXPECT_THROW(VideoReader({(folder.path() / "none.mkv").string()}, 1, stop), InputError);
  const auto text = folder.path() / "text.mkv";
  std::ofstream(text) << "this is no video";
  EXPECT_THROW(VideoReader({text.string()}, 1, stop), Error);
  EXPECT_THROW(VideoWriter(folder.path() / "odd.mp4", 63, 48, {}), InputError);
}

TEST(Video, leavesNothingWithoutFinish) {
  const test::TemporaryFolder folder;
  {
    VideoWriter writer(folder.path() / "a.mkv", 64, 48, {});
    writer.add(toneAt(1), 0);
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.mkv"));
}

std::string openError(const VideoSource& source) {
  const std::atomic<bool> stop = false;
  try {
    const VideoReader reader(source, 5, stop);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(VideoSource, saysWhatToDo) {
  using testing::HasSubstr;
  EXPECT_THAT(openError({"v4l2:/dev/video-unplugged"}), HasSubstr("connect the camera"));
  EXPECT_THAT(openError({"v4l2:/dev/null"}), HasSubstr("try:"));
  EXPECT_THAT(openError({"tcp://127.0.0.1:1"}), HasSubstr("start what sends it"));
  EXPECT_THAT(openError({"http://127.0.0.1:1/feed"}), HasSubstr("start what sends it"));
  EXPECT_THAT(openError({"https://127.0.0.1:1/feed"}), HasSubstr("the certificate of the server"));
  EXPECT_THAT(openError({"gopher-nine://127.0.0.1/"}), HasSubstr("cannot read such sources"));
  EXPECT_THAT(openError({"/nowhere/a.mkv"}), HasSubstr("paths begin in its folder"));
}

TEST(VideoSource, namesOptionsThatFfmpegDoesNotKnow) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "a.mkv").string();
  VideoWriter writer(path, 32, 32, {});
  writer.add(Image<Rgb8>(32, 32, Rgb8(9)), 0);
  writer.finish();
  EXPECT_EQ(openError({path}), "");
  EXPECT_THAT(openError({path, 0, 0, 0, {"no_such=1"}}), testing::HasSubstr("no option \"no_such\""));
  EXPECT_THAT(openError({path, 0, 0, 0, {"nothing"}}), testing::HasSubstr("NAME=VALUE"));
}

TEST(VideoSource, kindsAreKnownByTheirBeginnings) {
  EXPECT_TRUE(videoSourceKind("rtsp://camera/left").mayBeLive);
  EXPECT_TRUE(videoSourceKind("https://camera/left").mayBeLive);
  EXPECT_FALSE(videoSourceKind("https://camera/left").isAlwaysLive) << "it may be a video with a length";
  EXPECT_TRUE(videoSourceKind("tcp://127.0.0.1:9000?listen").isAlwaysLive);
  for (const char* address :
       {"rtmp://server/live/left", "srt://127.0.0.1:9000?mode=listener", "rtp://127.0.0.1:9000"}) {
    EXPECT_TRUE(videoSourceKind(address).mayBeLive) << address;
  }
  EXPECT_TRUE(videoSourceKind("v4l2:/dev/video0").takesSize);
  EXPECT_FALSE(videoSourceKind("v4l2.mkv").mayBeLive);
  EXPECT_FALSE(videoSourceKind("/videos/rtsp.mkv").mayBeLive);
}

}  // namespace
}  // namespace ocelli
