// Feeds by their timestamps, and feeds that end, are lost, or hang.
#include "oc_core/feeds_live/feed_stream.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "oc_core/base/random_numbers.h"
#include "oc_core/feeds_live/feed_labels.h"
#include "oc_core/feeds_video/video_writer.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

Image<Rgb8> flat(int tone) {
  return Image<Rgb8>(32, 32, Rgb8(static_cast<uint8_t>(tone)));
}

Feed feedOf(const std::filesystem::path& path, double offset) {
  Feed feed;
  feed.name = "door";
  feed.source = path.string();
  feed.width = 32;
  feed.height = 32;
  feed.clockOffsetSeconds = offset;
  return feed;
}

/// Frame k has the tone k, at times[k].
void writeFrames(const std::filesystem::path& path, const std::vector<double>& times) {
  VideoWriter writer(path, 32, 32, {10, 20, true});
  for (size_t k = 0; k < times.size(); ++k) {
    writer.add(flat(static_cast<int>(k)), times[k]);
  }
  writer.finish();
}

TEST(FeedStream, givesTheNewestFrameUntilATime) {
  const test::TemporaryFolder folder;
  writeFrames(folder.path() / "a.mkv", {0.5, 0.6, 0.7, 1.0, 1.1});
  FeedStream stream(feedOf(folder.path() / "a.mkv", 0.5), {});
  EXPECT_NEAR(*stream.firstSeconds(), 0, 1e-3);
  EXPECT_EQ(stream.take(0.05)->image, flat(0));
  EXPECT_FALSE(stream.take(0.08)) << "nothing new";
  EXPECT_EQ(stream.take(0.25)->image, flat(2)) << "frame 1 is skipped";
  EXPECT_FALSE(stream.take(0.45)) << "frames are lacking there";
  EXPECT_EQ(stream.take(0.55)->image, flat(3));
  EXPECT_EQ(stream.take(2)->image, flat(4));
  EXPECT_FALSE(stream.take(3));
  EXPECT_EQ(stream.state(), FeedState::kEnded);
  EXPECT_EQ(stream.framesSkipped(), 1u);
  EXPECT_EQ(stream.framesRead(), 5u);
}

TEST(FeedStream, aFileThatIsCutOffIsLostAndSaysSo) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.mkv";
  RandomNumbers random(1, 1);
  VideoWriter writer(path, 32, 32, {10, 20, true});
  for (int k = 0; k < 40; ++k) {
    Image<Rgb8> noise(32, 32);
    for (Rgb8& pixel : noise) {
      pixel = Rgb8(static_cast<uint8_t>(random.below(256)));
    }
    writer.add(noise, 0.1 * k);
  }
  writer.finish();
  const auto endOf = [&] {
    FeedStream stream(feedOf(path, 0), {});
    stream.firstSeconds();
    stream.take(10);
    return std::pair(stream.state(), stream.message());
  };
  EXPECT_EQ(endOf().first, FeedState::kEnded) << endOf().second;
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  const auto [state, message] = endOf();
  EXPECT_EQ(state, FeedState::kLost);
  EXPECT_NE(message.find("it is cut off"), std::string::npos) << message;
}

TEST(FeedStream, longFeedsPassThroughAShortQueue) {
  const test::TemporaryFolder folder;
  std::vector<double> times;
  for (int k = 0; k < 100; ++k) {
    times.push_back(0.1 * k);
  }
  writeFrames(folder.path() / "a.mkv", times);
  FeedStream stream(feedOf(folder.path() / "a.mkv", 0), {});
  EXPECT_EQ(stream.take(9.05)->image, flat(90)) << "90 frames are passed over at once";
}

TEST(FeedStream, framesThatAreAllTheSameAreFrozen) {
  const test::TemporaryFolder folder;
  VideoWriter writer(folder.path() / "a.mkv", 32, 32, {10, 20, true});
  for (int k = 0; k < 30; ++k) {
    writer.add(flat(std::min(k, 5)), 0.1 * k);
  }
  writer.finish();
  FeedStream stream(feedOf(folder.path() / "a.mkv", 0), {});
  for (int k = 0; k < 14; ++k) {
    stream.take(0.1 * k + 0.01);
    EXPECT_EQ(stream.state(), FeedState::kLive) << k;
  }
  stream.take(1.61);
  EXPECT_EQ(stream.state(), FeedState::kFrozen);
}

TEST(FeedStream, saysWhyItIsLost) {
  FeedStream missing(feedOf("/nowhere/none.mkv", 0), {});
  EXPECT_FALSE(missing.firstSeconds());
  EXPECT_EQ(missing.state(), FeedState::kLost);
  EXPECT_THAT(missing.message(), testing::HasSubstr("/nowhere/none.mkv"));
  const test::TemporaryFolder folder;
  writeFrames(folder.path() / "a.mkv", {0});
  Feed wrong = feedOf(folder.path() / "a.mkv", 0);
  wrong.width = 64;
  FeedStream small(wrong, {});
  EXPECT_FALSE(small.firstSeconds());
  EXPECT_THAT(small.message(), testing::HasSubstr("32x32"));
}

/// A pipe into which half of a video is written, and which then stays open.
TEST(FeedStream, oneThatIsCutOffBeforeItsFirstFrameIsLost) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.mkv";
  writeFrames(path, {0, 0.1, 0.2, 0.3});
  size_t lost = 0;
  for (auto size = std::filesystem::file_size(path) - 1; size > 0; size -= std::min<uintmax_t>(size, 60)) {
    std::filesystem::resize_file(path, size);
    FeedStream stream(feedOf(path, 0), {});
    stream.take(10);
    if (stream.framesRead() == 0) {
      EXPECT_EQ(stream.state(), FeedState::kLost) << size;
      EXPECT_NE(stream.message(), "") << size;
      ++lost;
    }
  }
  EXPECT_GT(lost, 3u);
}

TEST(FeedStream, isWaitedForOnceWhereItHangs) {
  const test::TemporaryFolder folder;
  writeFrames(folder.path() / "a.mkv", {0, 0.1, 0.2});
  std::ifstream file(folder.path() / "a.mkv", std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  const std::string pipe = (folder.path() / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int end = open(pipe.c_str(), O_RDWR);  // does not wait for a reader
  ASSERT_EQ(write(end, bytes.data(), 20), 20);
  const auto began = std::chrono::steady_clock::now();
  {
    FeedStream stream(feedOf(pipe, 0), {0.2, 30, 1});
    EXPECT_FALSE(stream.firstSeconds());
    EXPECT_EQ(stream.state(), FeedState::kLate);
    for (int k = 0; k < 50; ++k) {
      EXPECT_FALSE(stream.take(0.1 * k));
    }
  }
  close(end);
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  EXPECT_LT(took, 5) << "50 waits of 0.2 s would be 10 s";
}

TEST(FeedLabels, sayTheTimeAndTheState) {
  EXPECT_EQ(feedLabelText("left", {FeedState::kLive, true, 0.033}), "left 33 ms");
  EXPECT_EQ(feedLabelText("left", {FeedState::kLate, true, 2.42}), "left LATE 2.4 s");
  EXPECT_EQ(feedLabelText("the yard behind the gate of the north wing", {FeedState::kLive, true, 0.033}),
            "the yard behind th.. 33 ms");
  EXPECT_EQ(feedLabelText("left", {FeedState::kLost, false, 0}), "left LOST no picture");
  const FeedLabel moved{FeedState::kLive, true, 0.033, "MOVED 14 px"};
  EXPECT_EQ(feedLabelText("left", moved), "left MOVED 14 px 33 ms");
  EXPECT_FALSE(moved.isGood());
  EXPECT_TRUE((FeedLabel{FeedState::kLive, true, 0.033}.isGood()));
}

}  // namespace
}  // namespace ocelli
