#include "oc_core/remote_measure/frame_play.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/remote_measure/measured_paths.h"

namespace ocelli {
namespace {

using testing::ElementsAre;

/// A format that takes 84 bytes a frame: 100 on the wire.
const ColorCodec kFixedCodec{"fixed",
                             "",
                             "",
                             true,
                             false,
                             [](const Image<Rgb8>& image, double) {
                               std::vector<std::byte> bytes(84);
                               bytes[0] = std::byte{image[0].x};
                               return bytes;
                             },
                             [](std::span<const std::byte> bytes, glm::ivec2 size) {
                               return Image<Rgb8>(size.x, size.y, Rgb8(static_cast<uint8_t>(bytes[0])));
                             }};

PathFilm grayFilm(size_t frames, double framesPerSecond) {
  std::vector<Image<Rgb8>> images;
  for (size_t i = 0; i < frames; ++i) {
    images.emplace_back(4, 2, Rgb8(static_cast<uint8_t>(i)));
  }
  return {images, framesPerSecond};
}

// 10 frames a second. A frame asked for at 0 comes at 0.1 (up) + 0.05 + 0.05 (100 bytes at 2000 a second) + 0.1 = 0.3
// s; the next one is of the view at 0.3 s.
TEST(FramePlay, asksForAFrameWhenTheLastHasCome) {
  const RemotePath path = turningPath(10, 10);
  const PathFilm film = grayFilm(10, 10);
  FrameBytes frames(film, kFixedCodec, 0);
  const Playback playback = playFrames(path, {2000, 0.2}, framePacings()[0], frames, 0.05);
  EXPECT_THAT(framesShown(playback), ElementsAre(-1, -1, -1, 0, 0, 0, 3, 3, 3, 6));
  EXPECT_EQ(playback.images, 4u);
  EXPECT_EQ(playback.bytes, 400u);
  EXPECT_NEAR(playback.firstPictureSeconds.value(), 0.3, 1e-12);
}

TEST(FramePlay, asksForNoFrameTwice) {
  const RemotePath path = turningPath(10, 10);
  const PathFilm film = grayFilm(10, 10);
  FrameBytes frames(film, kFixedCodec, 0);
  const Playback playback = playFrames(path, {1e6, 0.002}, framePacings()[0], frames, 0.001);
  EXPECT_EQ(playback.images, 10u);
  EXPECT_THAT(framesShown(playback), ElementsAre(-1, 0, 1, 2, 3, 4, 5, 6, 7, 8));
}

TEST(FramePlay, hasNoFirstPictureWhereNoneComesInTime) {
  const RemotePath path = turningPath(3, 10);
  const PathFilm film = grayFilm(3, 10);
  FrameBytes frames(film, kFixedCodec, 0);
  EXPECT_FALSE(playFrames(path, {400, 0.2}, framePacings()[0], frames, 0.05).firstPictureSeconds);
}

// The link takes a frame each 0.05 s, so that every one of them is sent.
TEST(FramePlay, sendsOnAsFastAsFramesCome) {
  const RemotePath path = turningPath(8, 10);
  const PathFilm film = grayFilm(8, 10);
  FrameBytes frames(film, kFixedCodec, 0);
  const Playback playback = playFrames(path, {2000, 0.2}, framePacings()[1], frames, 0.05);
  EXPECT_THAT(framesShown(playback), ElementsAre(-1, -1, -1, 0, 1, 2, 3, 4));
}

// At 400 bytes a second a frame takes 0.25 s: the link is free at 0.4, 0.65, 0.9, ... s, and the newest view that was
// there in time to be drawn is that of 0.15 s before.
TEST(FramePlay, sendsTheNewestViewWhenTheLinkIsFree) {
  const RemotePath path = turningPath(14, 10);
  const PathFilm film = grayFilm(14, 10);
  FrameBytes frames(film, kFixedCodec, 0);
  const Playback playback = playFrames(path, {400, 0.2}, framePacings()[1], frames, 0.05);
  // Frame 0 leaves from 0.15 to 0.4 s and comes at 0.5; that of 0.25 s (frame 2) from 0.4 to 0.65, 0.75; that of 0.5 s
  // (5) to 0.9, 1.0; that of 0.75 s (7) to 1.15, 1.25.
  EXPECT_THAT(framesShown(playback), ElementsAre(-1, -1, -1, -1, -1, 0, 0, 0, 2, 2, 5, 5, 5, 7));
}

TEST(FramePlay, showsWhatWasCompressed) {
  const PathFilm film = grayFilm(5, 10);
  FrameBytes frames(film, kFixedCodec, 0);
  EXPECT_EQ(frames.picture(3), film.frame(3));
  EXPECT_EQ(film.frames(), 5u);
}

}  // namespace
}  // namespace ocelli
