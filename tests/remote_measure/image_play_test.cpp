#include "oc_core/remote_measure/image_play.h"

#include <gtest/gtest.h>

#include "oc_core/worlds/scene_source.h"
#include "tests/remote_measure/measured_paths.h"

namespace ocelli {
namespace {

const RemoteScene& playedScene() {
  static const RemoteScene scene(loadScene("builtin:statues"));
  return scene;
}

RemoteSettings lightSettings() {
  RemoteSettings settings;
  settings.color = "png";
  settings.samples = 1;
  return settings;
}

ImagePlayOptions fixedTimes(double clientSeconds = 0.001) {
  ImagePlayOptions options;
  options.screen = {64, 36};
  options.serverSeconds = 0.05;
  options.clientFrameSeconds = clientSeconds;
  options.clientDecodeSeconds = 0;
  return options;
}

const ImageMode& modeOf(const char* name) {
  return *findImageMode(name);
}

Playback play(const RemotePath& path, const LinkSpeed& speed, const char* mode,
              const ImagePlayOptions& options = fixedTimes()) {
  const RemoteSettings settings = modeOf(mode).settings(lightSettings(), 1);
  return playImages(playedScene(), path, speed, modeOf(mode), settings, options, [](size_t, const Image<Rgb8>&) {});
}

TEST(ImagePlay, showsTheFirstImageWhenItsColorsHaveCome) {
  const RemotePath path = turningPath(3000, 1000, 0);
  const RemoteImage image = playedScene().answer({1, path.views[0], {64, 36}, {}}, lightSettings(), 1);
  ImagePlayOptions options = fixedTimes(0.0005);
  options.every = 1000;
  const Playback playback = play(path, {10e3, 0.2}, "gpc", options);
  EXPECT_EQ(playback.images, 1u);
  // 0.1 s up, 0.05 s on the server, its bytes, 0.1 s down, and to the next frame.
  const double color = static_cast<double>(image.headerJson.size() + 16 + bytesOnTheWire(image.color.size()));
  ASSERT_TRUE(playback.firstPictureSeconds);
  // Two times in the header, of up to 20 digits; a frame, and drawing.
  EXPECT_NEAR(*playback.firstPictureSeconds, 0.25 + color / 10e3, 0.004 + 0.0015);
  EXPECT_NEAR(static_cast<double>(playback.bytes), color + static_cast<double>(bytesOnTheWire(image.depth.size())), 40);
  for (size_t k = 0; k < path.views.size(); ++k) {
    EXPECT_EQ(playback.shown[k].frame.has_value(), path.secondsOf(k) + 0.0006 >= playback.firstPictureSeconds) << k;
  }
  EXPECT_EQ(coveredShare(playback.shown), 1);
}

// Colours are there at about 0.05 s; they and then all of the image are decoded, for 0.3 s each.
TEST(ImagePlay, waitsForItsDecoder) {
  const RemotePath path = turningPath(20, 10, 0);
  ImagePlayOptions options = fixedTimes();
  const Playback quick = play(path, {10e6, 0}, "gpc", options);
  options.clientDecodeSeconds = 0.3;
  const Playback slow = play(path, {10e6, 0}, "gpc", options);
  EXPECT_NEAR(quick.firstPictureSeconds.value(), 0.101, 1e-9);
  EXPECT_NEAR(slow.firstPictureSeconds.value(), 0.401, 1e-9);
  EXPECT_EQ(quick.clientDecodeSeconds, 0);
  EXPECT_NEAR(slow.clientDecodeSeconds, 0.6, 1e-9);
  // What it takes here is taken, too, where nothing else is told.
  options.clientDecodeSeconds = std::nullopt;
  EXPECT_GT(play(path, {10e6, 0}, "gpc", options).clientDecodeSeconds, 0);
}

TEST(ImagePlay, showsEveryViewWithinTheCoveredRegion) {
  const RemotePath path = turningPath(60, 60, 0.001);
  const Playback playback = play(path, {1e6, 0.2}, "gpc");
  EXPECT_EQ(playback.images, 1u);
  EXPECT_EQ(stallsOf(path, playback.shown, false).count, 1u) << "the wait for the first picture";
  EXPECT_EQ(stallsOf(path, playback.shown, true).count, 0u);
  for (size_t k = 30; k < 60; ++k) {
    EXPECT_EQ(playback.shown[k].frame, k);
  }
}

// A client that takes 0.25 s to draw begins at 0.1 s, where the image is there, and shows that frame from 0.35 s on;
// the next one is that of 0.35 s, which it shows from 0.6 s on, then that of 0.6 s, from 0.85 s on.
TEST(ImagePlay, isAsSlowAsItsClient) {
  const RemotePath path = turningPath(10, 10, 0.02);
  std::vector<Image<Rgb8>> pictures;
  const ImageMode& mode = modeOf("gpc");
  const Playback playback = playImages(playedScene(), path, {10e6, 0}, mode, lightSettings(), fixedTimes(0.25),
                                       [&](size_t, const Image<Rgb8>& picture) { pictures.push_back(picture); });
  EXPECT_EQ(framesShown(playback), (std::vector<int>{-1, -1, -1, -1, 1, 1, 3, 3, 3, 6}));
  EXPECT_NEAR(playback.firstPictureSeconds.value(), 0.35, 1e-9);
  EXPECT_GT(stallsOf(path, playback.shown, true).count, 0u);
  // What is judged is what is on the screen.
  ASSERT_EQ(pictures.size(), 10u);
  EXPECT_EQ(pictures[3], Image<Rgb8>(64, 36));
  EXPECT_EQ(pictures[4], pictures[5]);
  EXPECT_NE(pictures[5], pictures[6]);
  EXPECT_EQ(pictures[6], pictures[8]);
  EXPECT_NE(pictures[8], pictures[9]);
}

// With nothing told, all takes what it takes here; also without depth, where the time for coding it is left out.
TEST(ImagePlay, takesWhatItTakesHere) {
  const RemotePath path = turningPath(40, 10, 0.001);
  for (const char* mode : {"gpc", "gpc-zoom"}) {
    ImagePlayOptions options;
    options.screen = {64, 36};
    const Playback playback = play(path, {10e6, 0}, mode, options);
    EXPECT_GT(playback.clientFrameSeconds, 0) << mode;
    EXPECT_GT(playback.clientDecodeSeconds, 0) << mode;
    ASSERT_TRUE(playback.firstPictureSeconds) << mode;
    EXPECT_TRUE(playback.shown.back().frame) << mode;
  }
}

TEST(ImagePlay, hasNoFirstPictureWhereNoneComesInTime) {
  const RemotePath path = turningPath(3, 10);
  const Playback playback = play(path, {1e3, 0.2}, "gpc");
  EXPECT_FALSE(playback.firstPictureSeconds);
  EXPECT_EQ(framesShown(playback), (std::vector<int>{-1, -1, -1}));
}

TEST(ImagePlay, asksForMoreWhereTheViewLeaves) {
  const RemotePath path = turningPath(120, 60, 0.02);
  const Playback fast = play(path, {10e6, 0.02}, "gpc");
  EXPECT_GT(fast.images, 1u);
  EXPECT_EQ(coveredShare(fast.shown), 1);
  // Over a slow link images do not come in time.
  const Playback slow = play(path, {3e3, 0.2}, "gpc");
  EXPECT_LT(coveredShare(slow.shown), 1);
  EXPECT_LT(slow.images, fast.images);
}

TEST(ImagePlay, isTheSameEachTime) {
  const RemotePath path = turningPath(60, 60, 0.02);
  const Playback first = play(path, {30e3, 0.02}, "gpc");
  const Playback second = play(path, {30e3, 0.02}, "gpc");
  EXPECT_EQ(framesShown(first), framesShown(second));
  EXPECT_EQ(first.images, second.images);
}

TEST(ImagePlay, zoomsWithAQuarterOfMipmappingsPixels) {
  const RemoteSettings ours = lightSettings();
  const auto pixels = [&](const char* name) {
    const RemotePlan plan =
        planRemoteImage({0, turningPath(1, 1).views[0], {128, 72}, {}}, modeOf(name).settings(ours, 1));
    return plan.reference.width() * plan.reference.height();
  };
  EXPECT_EQ(pixels("mipmap"), 4 * 128 * 72);
  EXPECT_EQ(4 * pixels("gpc-zoom"), pixels("mipmap"));
  // Both have two samples a pixel in the middle.
  const RemotePath path = remotePath("zoom", turningPath(1, 1).views[0], 225, 60);
  const Playback zoom = play(path, {1e6, 0.02}, "gpc-zoom");
  const Playback mipmap = play(path, {1e6, 0.02}, "mipmap");
  EXPECT_EQ(zoom.images, mipmap.images);
  EXPECT_LT(zoom.bytes, mipmap.bytes);
}

TEST(ImagePlay, makesPlainImagesOfAsManyBytes) {
  const View view = turningPath(1, 1).views[0];
  const RemoteSettings ours = lightSettings();
  const double size = equalBytesSize(playedScene(), view, {96, 54}, ours);
  const auto bytesOf = [&](const RemoteSettings& settings) {
    const RemoteImage image = playedScene().answer({1, view, {96, 54}, {}}, settings, 1);
    return static_cast<double>(image.color.size() + image.depth.size());
  };
  EXPECT_NEAR(bytesOf(modeOf("di").settings(ours, size)) / bytesOf(ours), 1, 0.03);
  EXPECT_EQ(findImageMode("nothing"), nullptr);
}

}  // namespace
}  // namespace ocelli
