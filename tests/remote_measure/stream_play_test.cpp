#include "oc_core/remote_measure/stream_play.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/remote_measure/image_play.h"
#include "tests/remote_measure/measured_paths.h"

namespace ocelli {
namespace {

using testing::ElementsAre;

constexpr size_t kHeader = 16;  ///< bytes in front of a frame that is sent in one piece

// 10 frames a second; a view takes 0.1 s up, 0.05 s to draw and encode, 0.05 s to send (84 + 16 bytes at 2000 a second)
// and 0.1 s down: each frame is shown from 0.3 s after its view on.
TEST(StreamPlay, showsEachFrameALittleLater) {
  const RemotePath path = turningPath(8, 10);
  const std::vector<size_t> bytes(8, 100 - kHeader);
  const Playback playback = playStream(path, {2000, 0.2}, bytes, 0.05);
  EXPECT_THAT(framesShown(playback), ElementsAre(-1, -1, -1, 0, 1, 2, 3, 4));
  EXPECT_NEAR(playback.firstPictureSeconds.value(), 0.3, 1e-12);
  EXPECT_EQ(playback.bytes, 800u);
  EXPECT_EQ(playback.images, 8u);
  EXPECT_NEAR(stallsOf(path, playback.shown, false).totalSeconds, 0.3, 1e-12) << "the wait for the first picture";
}

// What an encoder may take goes over the link with its headers, and 5 % are left.
TEST(StreamPlay, leavesRoomForHeaders) {
  for (const double rate : {100e3, 300e3, 12.5e6}) {
    const double frame = streamBytesPerSecond({rate, 0.2}, 60) / 60;
    const double wire = 60 * static_cast<double>(bytesOnTheWire(static_cast<size_t>(frame)));
    EXPECT_LE(wire, 0.96 * rate) << rate;
    EXPECT_GE(wire, 0.94 * rate) << rate;
  }
  EXPECT_EQ(streamBytesPerSecond({1000, 0.2}, 60), 100) << "headers alone would take nearly all of it";
}

// A first frame of half a second holds up those behind it, which then follow at 0.05 s each: at 0.75, 0.8, ... s they
// leave, and arrive 0.1 s later.
TEST(StreamPlay, waitsForLargeFrames) {
  const RemotePath path = turningPath(12, 10);
  std::vector<size_t> bytes(12, 100 - kHeader);
  bytes[0] = 1000 - kHeader;
  const Playback playback = playStream(path, {2000, 0.2}, bytes, 0.05);
  EXPECT_NEAR(playback.firstPictureSeconds.value(), 0.15 + 0.5 + 0.1, 1e-12);
  // Frame j is there at max(0.75 + 0.05 j, ...) while the link is behind: 0.75, 0.8, 0.85, 0.9, 0.95, 1.0, 1.05, 1.1
  EXPECT_THAT(framesShown(playback), ElementsAre(-1, -1, -1, -1, -1, -1, -1, -1, 1, 3, 5, 7));
}

TEST(WireBytes, haveAHeaderAPiece) {
  EXPECT_EQ(bytesOnTheWire(0), 0u);
  EXPECT_EQ(bytesOnTheWire(1), 1 + kHeader);
  // A message of 32 KiB has 12 bytes of its own (docs/remote_protocol.md).
  EXPECT_EQ(bytesOnTheWire(32756), 32756 + kHeader);
  EXPECT_EQ(bytesOnTheWire(32757), 32757 + 2 * kHeader);
}

}  // namespace
}  // namespace ocelli
