// The pictures of the volume pane.
#include "display_sim/viewer/volume_painter.h"

#include <gmock/gmock.h>

#include "display_sim/viewer/volume_work.h"
#include "oc_core/base/error.h"
#include "oc_core/camera/gpc_camera.h"
#include "oc_core/volume_camera/volume_camera.h"
#include "oc_core/volume_camera/volume_image_file.h"
#include "oc_core/volume_render/volume_target.h"
#include "tests/base/temporary_folder.h"
#include "tests/viewer/lens_state.h"
#include "tests/viewer/transfer_state.h"

namespace ocelli {
namespace {

using test::kSmallVolume;

/// Looks past the scene, and turns back to it.
constexpr const char* kCurvedCamera = R"({"camera": "curved", "turns": [
    {"from": {"point": [4, 0, 3], "normal": [-0.25, 0, -1]}, "middle": {"point": [4, 0, 3], "normal": [0, 0, -1]},
     "to": {"point": [4, 0, 3], "normal": [0.25, 0, -1]}, "viewpoint": [-2, 0, 8]}]})";

std::shared_ptr<const LoadedScene> smallVolume() {
  static const auto scene = [] {
    LoadedScene loaded{kSmallVolume, 1, {}, {}};
    VolumeScene volume = loadVolumeScene(kSmallVolume);
    VolumeHistogram histogram = histogramOf(*volume.volume);
    loaded.volume = std::make_shared<const LoadedVolume>(LoadedVolume{std::move(volume), std::move(histogram)});
    return std::make_shared<const LoadedScene>(std::move(loaded));
  }();
  return scene;
}

VolumeWanted wantedVolume() {
  VolumeWanted wanted;
  wanted.shows = true;
  wanted.scene = smallVolume();
  wanted.view.eye = {1, 1.5f, 3};
  wanted.view.fovVerticalDegrees = 45;
  wanted.size = {48, 32};
  wanted.camera = cameraChoice("di");
  wanted.cameraRevision = 1;
  wanted.appearance = std::make_shared<const VolumeAppearance>(smallVolume()->volume->scene.appearance);
  return wanted;
}

/// As `ocelli render` makes it, with a renderer of its own.
template <class Camera>
Image<Rgb8> renderedVolume(const VolumeWanted& wanted, const Camera& camera) {
  VolumeScene scene = wanted.scene->volume->scene;
  scene.appearance = *wanted.appearance;
  scene.clips = clipsOf(wanted.scene->volume->scene, wanted.kept);
  const VolumeImage pixels = renderVolume(camera, scene);
  Image<glm::vec3> colors(pixels.width(), pixels.height());
  for (size_t i = 0; i < pixels.size(); ++i) {
    colors[i] = colorBefore(glm::vec3(0), pixels[i]);
  }
  return srgbFromLinear(colors);
}
PinholeCamera pinholeOf(const VolumeWanted& wanted) {
  return {wanted.view, wanted.size.x, wanted.size.y};
}
size_t litPixels(const Image<Rgb8>& image) {
  return static_cast<size_t>(std::ranges::count_if(image, [](const Rgb8& pixel) { return pixel != Rgb8(0); }));
}

TEST(VolumePainter, paintsWhatRenderDrawsWhateverChanges) {
  VolumePainter painter;
  VolumeWanted wanted = wantedVolume();
  const Image<Rgb8> first = painter.paint(wanted, wanted.size);
  EXPECT_EQ(first, renderedVolume(wanted, pinholeOf(wanted)));
  EXPECT_GT(litPixels(first), first.size() / 10);

  TransferEditor editor(*wanted.appearance);
  editor.colorPoint(0, {0, 1, 1});
  editor.colorPoint(1, {0, 0, 1});
  editor.setShading({.isOn = false});
  wanted.appearance = editor.appearance();
  const Image<Rgb8> blue = painter.paint(wanted, wanted.size);
  EXPECT_EQ(blue, renderedVolume(wanted, pinholeOf(wanted)));
  EXPECT_NE(blue, first);

  wanted.kept[0] = {0, 0.5};
  const Image<Rgb8> half = painter.paint(wanted, wanted.size);
  EXPECT_EQ(half, renderedVolume(wanted, pinholeOf(wanted)));
  EXPECT_LT(litPixels(half), litPixels(blue));

  wanted.kept[0] = {0, 1};
  wanted.view.eye.x = -2;
  EXPECT_EQ(painter.paint(wanted, wanted.size), renderedVolume(wanted, pinholeOf(wanted)));
  wanted.size = {30, 20};
  EXPECT_EQ(painter.paint(wanted, wanted.size), renderedVolume(wanted, pinholeOf(wanted)));
}

TEST(VolumePainter, aPreviewIsCoarserAndTheWholePictureIsNot) {
  VolumePainter painter;
  VolumeWanted wanted = wantedVolume();
  const Image<Rgb8> small = painter.paint(wanted, {24, 16});
  EXPECT_EQ(small.width(), 24);
  VolumeWanted whole = wanted;
  whole.size = {24, 16};
  EXPECT_NE(small, renderedVolume(whole, pinholeOf(whole))) << "its samples stand farther apart";
  EXPECT_EQ(painter.paint(wanted, wanted.size), renderedVolume(wanted, pinholeOf(wanted)));
}

TEST(VolumePainter, followsTheRaysOfLenses) {
  VolumePainter painter;
  VolumeWanted wanted = wantedVolume();
  wanted.camera = cameraChoice("gpc");
  wanted.camera.gpc = test::lensState().work.camera.gpc;
  const Image<Rgb8> picture = painter.paint(wanted, wanted.size);
  EXPECT_EQ(picture, renderedVolume(wanted, GpcCamera(pinholeOf(wanted), wanted.camera.gpc)));
  EXPECT_NE(picture, renderedVolume(wanted, pinholeOf(wanted)));
}

TEST(VolumePainter, followsTheRaysOfOcclusionCamerasAndOfConstructors) {
  VolumePainter painter;
  VolumeWanted wanted = wantedVolume();
  const VolumeRenderer renderer(wanted.scene->volume->scene);
  const VolumeTarget target(renderer);
  const auto expected = [&](const std::string& name) {
    const VolumeCamera camera =
        volumeCamera(name, pinholeOf(wanted), renderer.scene(), [&]() -> const RayTarget& { return target; });
    return srgbFromLinear(imageBefore(glm::vec3(0), renderer.render(camera.size.x, camera.size.y, camera.ray)));
  };
  wanted.camera = cameraChoice("ddoc");
  EXPECT_EQ(painter.paint(wanted, wanted.size), expected("ddoc"));
  const test::TemporaryFolder folder;
  wanted.view = {};
  wanted.rays = folder.write("curved.json", kCurvedCamera).string();
  const Image<Rgb8> curved = painter.paint(wanted, wanted.size);
  EXPECT_EQ(curved, expected(wanted.rays));
  EXPECT_NE(curved, renderedVolume(wanted, pinholeOf(wanted)));
}

TEST(VolumePainter, saysWhichCamerasHaveNoRays) {
  VolumePainter painter;
  VolumeWanted wanted = wantedVolume();
  wanted.camera = cameraChoice("eoc-hv+ddoc");
  EXPECT_THROW(painter.paint(wanted, wanted.size), InputError);
}

TEST(VolumePainter, progressMayEndIt) {
  struct Ended {};
  VolumePainter painter;
  const VolumeWanted wanted = wantedVolume();
  EXPECT_THROW(painter.paint(wanted, wanted.size, [](std::string_view, double) { throw Ended{}; }), Ended);
  EXPECT_EQ(painter.paint(wanted, wanted.size), renderedVolume(wanted, pinholeOf(wanted)))
      << "and is as good as before";
}

TEST(VolumeWork, drawsTheNewestWishAndForgetsWhatIsHidden) {
  VolumeWork work;
  VolumeWanted wanted = wantedVolume();
  for (int i = 0; i < 10; ++i) {
    wanted.view.eye.x = 0.1f * static_cast<float>(i);
    work.want(wanted);
  }
  work.waitUntilIdle();
  ASSERT_TRUE(work.status().picture) << work.status().error;
  EXPECT_TRUE(work.status().picture->isWhole);
  EXPECT_EQ(work.status().picture->image, renderedVolume(wanted, pinholeOf(wanted)));
  wanted.shows = false;
  work.want(wanted);
  work.waitUntilIdle();
  EXPECT_FALSE(work.status().picture);
}

}  // namespace
}  // namespace ocelli
