// By ffmpeg itself where it is there, and by programs that stand for it.
#include "oc_core/remote_measure/video_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "oc_core/base/error.h"
#include "oc_core/image/image_error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

/// A bright square that goes to the right over a gradient.
PathFilm squareFilm(size_t frames, const glm::ivec2& size = {64, 48}) {
  std::vector<Image<Rgb8>> images;
  for (size_t i = 0; i < frames; ++i) {
    Image<Rgb8> image(size.x, size.y);
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        const bool isIn = std::abs(x - 10 - 2 * static_cast<int>(i)) < 8 && std::abs(y - 24) < 8;
        image(x, y) = isIn ? Rgb8(250, 200, 40) : Rgb8(static_cast<uint8_t>(2 * x), static_cast<uint8_t>(3 * y), 90);
      }
    }
    images.push_back(image);
  }
  return {images, 60};
}

class VideoStream : public testing::TestWithParam<const StreamKind*> {
 protected:
  void SetUp() override {
    if (!encoder_.isThere()) {
      GTEST_SKIP() << encoder_.missing();
    }
  }
  const StreamEncoder encoder_{*GetParam()};
};

TEST_P(VideoStream, givesBackItsFrames) {
  const PathFilm film = squareFilm(10);
  const StreamEncoder::Stream stream = encoder_.encode(film, {10, std::nullopt});
  EXPECT_EQ(stream.frameBytes.size(), 10u);
  EXPECT_GT(stream.frameBytes[0], stream.frameBytes[5]) << "the first frame alone is a whole one";
  std::vector<size_t> got;
  encoder_.decode(stream, film.screen(), {0, 4, 9}, [&](size_t frame, const Image<Rgb8>& picture) {
    got.push_back(frame);
    // Colours at half of the resolution blur the square's rim; another frame differs by more.
    EXPECT_GT(psnrDecibels(meanSquaredError(picture, film.frame(frame))), 26);
    EXPECT_LT(psnrDecibels(meanSquaredError(picture, film.frame(frame == 4 ? 8 : 4))), 24);
  });
  EXPECT_THAT(got, testing::ElementsAre(0, 4, 9));
}

TEST_P(VideoStream, takesFewerBytesForLessQuality) {
  const PathFilm film = squareFilm(10);
  EXPECT_LT(encoder_.encode(film, {40, std::nullopt}).bytes(), encoder_.encode(film, {10, std::nullopt}).bytes());
}

TEST_P(VideoStream, keepsToTheRateOfALink) {
  const PathFilm film = squareFilm(60);
  const size_t free = encoder_.encode(film, {4, std::nullopt}).bytes();
  const double rate = static_cast<double>(free) / 3;
  // A second of film, and what the buffer holds.
  EXPECT_LT(static_cast<double>(encoder_.encode(film, {4, rate}).bytes()), 1.4 * rate);
}

TEST_P(VideoStream, takesEvenSizesOnly) {
  EXPECT_THROW(encoder_.encode(squareFilm(2, {33, 20}), {20, std::nullopt}), InputError);
}

INSTANTIATE_TEST_SUITE_P(Kinds, VideoStream,
                         testing::Values(findStreamKind("x264"), findStreamKind("x265"), findStreamKind("x264-444"),
                                         findStreamKind("x265-444")),
                         [](const auto& kind) {
                           std::string name = kind.param->name;
                           std::erase(name, '-');
                           return name;
                         });

TEST(VideoStreams, keepFullColorWhereTheySaySo) {
  // Red and blue columns, of one pixel each.
  Image<Rgb8> columns(64, 48);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      columns(x, y) = x % 2 == 0 ? Rgb8(200, 0, 0) : Rgb8(0, 0, 200);
    }
  }
  const PathFilm film({columns, columns}, 60);
  const auto decibels = [&](const char* name) {
    const StreamEncoder encoder(*findStreamKind(name));
    double value = 0;
    if (encoder.isThere()) {
      encoder.decode(
          encoder.encode(film, {5, std::nullopt}), film.screen(), {1},
          [&](size_t, const Image<Rgb8>& picture) { value = psnrDecibels(meanSquaredError(picture, columns)); });
    }
    return value;
  };
  if (decibels("x264") == 0) {
    GTEST_SKIP() << "no x264";
  }
  EXPECT_GT(decibels("x264-444"), decibels("x264") + 10);
}

// More frames than one argument of a program can name.
TEST(VideoStreams, giveBackVeryManyFrames) {
  const StreamEncoder encoder(*findStreamKind("x264"));
  if (!encoder.isThere()) {
    GTEST_SKIP() << encoder.missing();
  }
  constexpr size_t kFrames = 12000;
  std::vector<Image<Rgb8>> images;
  std::vector<size_t> frames;
  for (size_t i = 0; i < kFrames; ++i) {
    images.emplace_back(16, 16, Rgb8(static_cast<uint8_t>(i / 100)));
    if (i % 10 != 5) {
      frames.push_back(i);
    }
  }
  const PathFilm film(images, 60);
  std::vector<size_t> got;
  int worst = 0;
  encoder.decode(encoder.encode(film, {20, std::nullopt}), film.screen(), frames,
                 [&](size_t frame, const Image<Rgb8>& picture) {
                   got.push_back(frame);
                   worst = std::max(worst, std::abs(picture(8, 8).x - static_cast<int>(frame / 100)));
                 });
  EXPECT_EQ(got, frames);
  EXPECT_LE(worst, 4) << "a frame of another moment differs by more";
}

class WithoutVideo : public testing::Test {
 protected:
  void SetUp() override { old_ = std::getenv("PATH"); }
  void TearDown() override { setenv("PATH", old_.c_str(), 1); }
  const test::TemporaryFolder folder_;
  std::string old_;
};

TEST_F(WithoutVideo, saysThatFfmpegIsMissing) {
  setenv("PATH", (folder_ / ".").c_str(), 1);
  const StreamEncoder encoder(*findStreamKind("x265"));
  EXPECT_FALSE(encoder.isThere());
  EXPECT_THAT(encoder.missing(), HasSubstr("apt-get install ffmpeg"));
}

TEST_F(WithoutVideo, saysThatAnEncoderIsMissing) {
  std::filesystem::permissions(folder_.write("ffmpeg", "#!/bin/sh\necho no such encoder\nexit 1\n"),
                               std::filesystem::perms::owner_all);
  setenv("PATH", (folder_ / ".").c_str(), 1);
  const StreamEncoder encoder(*findStreamKind("x265"));
  EXPECT_THAT(encoder.missing(), HasSubstr("libx265"));
}

TEST_F(WithoutVideo, passesOnWhatFfmpegSays) {
  // Its probe succeeds, encoding does not.
  std::filesystem::permissions(
      folder_.write("ffmpeg", "#!/bin/sh\ncase \"$*\" in *lavfi*) exit 0;; esac\necho the disk is full\nexit 1\n"),
      std::filesystem::perms::owner_all);
  setenv("PATH", (folder_ / ".").c_str(), 1);
  const StreamEncoder encoder(*findStreamKind("x264"));
  ASSERT_TRUE(encoder.isThere());
  try {
    encoder.encode(squareFilm(2), {20, std::nullopt});
    FAIL();
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the disk is full"));
  }
}

}  // namespace
}  // namespace ocelli
