// The pictures of the lens pane, and their work in the background.
#include "display_sim/viewer/lens_work.h"

#include <gmock/gmock.h>

#include "display_sim/viewer/lens_file.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "tests/base/temporary_folder.h"
#include "tests/viewer/lens_state.h"

namespace ocelli {
namespace {

using test::lensState;
using test::TemporaryFolder;

std::shared_ptr<const LoadedScene> teapot() {
  static const auto scene = [] {
    LoadedScene loaded{"builtin:teapot", 1, loadScene("builtin:teapot"), {}};
    loaded.bounds = boundsOf(loaded.mesh);
    return std::make_shared<const LoadedScene>(std::move(loaded));
  }();
  return scene;
}

LensWanted wantedPicture() {
  LensWanted wanted;
  wanted.shows = true;
  wanted.scene = teapot();
  wanted.size = {160, 90};
  wanted.layout = lensState().work.camera.gpc;
  return wanted;
}

/// As `ocelli render` makes it.
Image<Rgb8> rendered(const LensWanted& wanted) {
  CameraChoice camera = cameraChoice("gpc");
  camera.gpc = wanted.layout;
  const PinholeCamera reference(wanted.view, wanted.size.x, wanted.size.y);
  return srgbFromLinear(wanted.method == LensesShown::Method::kRays
                            ? raycastReferenceImage(camera, reference, wanted.scene->mesh).color
                            : buildReferenceImages(camera, reference, wanted.scene->mesh).front().color);
}

TEST(LensPainter, paintsWhatRenderDrawsHoweverOftenLensesMove) {
  LensPainter painter;
  LensWanted wanted = wantedPicture();
  for (const LensesShown::Method method : {LensesShown::Method::kRaster, LensesShown::Method::kRays}) {
    wanted.method = method;
    for (const double x : {0.15, 0.3, 0.45}) {
      moveLens(wanted.layout, 0, {x, 0.4}, {160, 90});
      EXPECT_EQ(painter.paint(wanted, wanted.size), rendered(wanted));
    }
    wanted.view.eye.x += 0.5f;
    EXPECT_EQ(painter.paint(wanted, wanted.size), rendered(wanted)) << "another eye";
    wanted.size = {100, 70};
    EXPECT_EQ(painter.paint(wanted, wanted.size), rendered(wanted)) << "another size";
  }
}

TEST(LensPainter, paintsThePinholeWhereThereIsNoLens) {
  LensPainter painter;
  LensWanted wanted = wantedPicture();
  wanted.layout.regions.clear();
  const PinholeCamera reference(wanted.view, wanted.size.x, wanted.size.y);
  EXPECT_EQ(painter.paint(wanted, wanted.size),
            srgbFromLinear(buildReferenceImages(cameraChoice("di"), reference, wanted.scene->mesh).front().color));
}

TEST(LensPainter, ratesAreColoursOfTheScale) {
  LensPainter painter;
  LensWanted wanted = wantedPicture();
  wanted.layout.regions[1].zoom = 8;
  wanted.view.target = {50, 50, 50};  // beside the scene: black
  wanted.view.eye = {60, 60, 60};
  wanted.rates = true;
  const Image<Rgb8> heat = painter.paint(wanted, wanted.size);
  const RateRange range = rateRangeOf(wanted.layout);
  EXPECT_EQ(range.greatest, 8);
  EXPECT_LT(range.least, 0.6);
  // The greatest rate is the darkest colour.
  const auto brightness = [](const Rgb8& pixel) { return pixel.x + pixel.y + pixel.z; };
  const int inLens = brightness(heat(112, 45));
  EXPECT_LT(inLens, brightness(heat(32, 45))) << "8x against 3x";
  EXPECT_LT(brightness(heat(32, 45)), brightness(heat(72, 10))) << "3x against the pinhole's";
}

TEST(LensWork, drawsTheNewestWish) {
  LensWork work;
  LensWanted wanted = wantedPicture();
  for (int i = 0; i < 20; ++i) {
    moveLens(wanted.layout, 0, {0.1 + 0.02 * i, 0.4}, {160, 90});
    work.want(wanted);
  }
  work.waitUntilIdle();
  const LensStatus status = work.status();
  ASSERT_TRUE(status.picture) << status.error;
  EXPECT_TRUE(status.picture->isWhole);
  EXPECT_EQ(status.picture->wanted, wanted);
  EXPECT_EQ(status.picture->image, rendered(wanted));
  wanted.shows = false;
  work.want(wanted);
  work.waitUntilIdle();
  EXPECT_FALSE(work.status().picture);
}

TEST(LensFile, isReadBackAsItWas) {
  const TemporaryFolder folder;
  GpcLayout layout = lensState().work.camera.gpc;
  layout.sampling = findGpcSampling("quadratic");
  moveLens(layout, 0, {1.0 / 3, 0.123456789}, {160, 90});
  layout.regions[1].zoom = 2.7182818f;
  const auto path = folder.path() / "lenses.json";
  writeFile(path, lensFileText(layout));
  EXPECT_EQ(cameraChoice(path.string()).gpc, layout);
  EXPECT_THAT(lensFileText(layout), testing::HasSubstr("\"extent\": [0.1, 0.1]"));
  layout.regions.clear();
  EXPECT_THROW(lensFileText(layout), InputError);
}

}  // namespace
}  // namespace ocelli
