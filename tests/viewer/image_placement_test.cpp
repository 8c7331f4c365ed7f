#include "display_sim/viewer/image_placement.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

const glm::ivec2 kImage(720, 480);
const glm::ivec2 kPane(360, 400);

TEST(ImagePlacement, theWholeImageFitsAtFirst) {
  const ImagePlacement placement = placeImage({}, kImage, kPane);
  EXPECT_FLOAT_EQ(placement.pixelStep, 2);  // its width decides
  EXPECT_FLOAT_EQ(placement.firstPixel.x, 0);
  EXPECT_FLOAT_EQ(placement.firstPixel.y, 240 - 400);
}

TEST(ImagePlacement, pixelsAreFoundAndWhatIsBesideIsNot) {
  const ImagePlacement placement = placeImage({}, kImage, kPane);
  EXPECT_EQ(pixelAt(placement, kImage, {0.4f, 80}), glm::ivec2(0, 0));
  EXPECT_EQ(pixelAt(placement, kImage, {359.9f, 319.9f}), glm::ivec2(719, 479));
  EXPECT_FALSE(pixelAt(placement, kImage, {100, 79.4f}).has_value());
  EXPECT_FALSE(pixelAt(placement, kImage, {100, 320.1f}).has_value());
}

TEST(ImagePlacement, whatIsUnderThePointerStaysThere) {
  ReferenceShown shown;
  const glm::vec2 at(100, 150);
  const glm::vec2 before = placeImage(shown, kImage, kPane).imageFromPane(at);
  for (const double factor : {3.0, 1.7, 0.5}) {
    zoomAt(shown, kImage, kPane, at, factor);
    const glm::vec2 after = placeImage(shown, kImage, kPane).imageFromPane(at);
    EXPECT_NEAR(after.x, before.x, 0.01f);
    EXPECT_NEAR(after.y, before.y, 0.01f);
  }
}

TEST(ImagePlacement, zoomStaysWithinItsLimits) {
  ReferenceShown shown;
  zoomAt(shown, kImage, kPane, {0, 0}, 0.01);
  EXPECT_EQ(shown.zoom, 1);
  zoomAt(shown, kImage, kPane, {0, 0}, 1e9);
  EXPECT_EQ(shown.zoom, kMaxReferenceZoom);
}

TEST(ImagePlacement, draggingMovesTheImageAlong) {
  ReferenceShown shown;
  zoomAt(shown, kImage, kPane, {180, 200}, 4);
  const glm::vec2 before = placeImage(shown, kImage, kPane).imageFromPane({50, 60});
  dragImage(shown, kImage, kPane, {10, -20});
  const glm::vec2 after = placeImage(shown, kImage, kPane).imageFromPane({60, 40});
  EXPECT_NEAR(after.x, before.x, 0.01f);
  EXPECT_NEAR(after.y, before.y, 0.01f);
}

TEST(ImagePlacement, draggingKeepsTheImageInSight) {
  ReferenceShown shown;
  dragImage(shown, kImage, kPane, {1e6f, 1e6f});
  EXPECT_EQ(shown.center, glm::vec2(0, 0));
}

}  // namespace
}  // namespace ocelli
