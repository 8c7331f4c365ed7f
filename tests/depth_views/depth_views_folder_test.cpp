#include "oc_core/depth_views/depth_views_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "oc_core/image/level_png.h"
#include "oc_core/image/png_file.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/reference_image_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/depth_views/test_views.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::TemporaryFolder;
using testing::HasSubstr;

std::string readingError(const std::filesystem::path& folder) {
  try {
    readDepthViews(folder);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DepthViewsFolder, exrFilesComeBackExactly) {
  const TemporaryFolder folder;
  const std::vector<DepthView> views = test::cornerViews(test::tiltedPlane(0.5f), 4);
  writeDepthViews(folder / "views", views, depthViewsFormats()[0]);
  const std::vector<DepthView> back = readDepthViews(folder / "views");
  ASSERT_EQ(back.size(), views.size());
  for (size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(back[i].name, views[i].name);
    EXPECT_EQ(back[i].image.t, views[i].image.t);
    EXPECT_EQ(back[i].image.color, views[i].image.color);
    EXPECT_EQ(back[i].image.view.eye, views[i].image.view.eye);
  }
}

// Equal steps of 1/z: half a step of it is the most that a depth is off. Colours are off by half a byte of sRGB.
TEST(DepthViewsFolder, pngFilesComeBackWithinTheirSteps) {
  const TemporaryFolder folder;
  const std::vector<DepthView> views = test::cornerViews(test::tiltedPlane(0.5f), 4);
  writeDepthViews(folder / "views", views, depthViewsFormats()[1]);
  const std::vector<DepthView> back = readDepthViews(folder / "views");
  ASSERT_EQ(back.size(), views.size());
  for (size_t i = 0; i < views.size(); ++i) {
    const ReferenceImage& image = views[i].image;
    ASSERT_EQ(back[i].image.held, image.held);
    float near = 1e9f;
    float far = 0;
    for (size_t pixel = 0; pixel < image.t.size(); ++pixel) {
      near = image.holds(pixel) ? std::min(near, image.t[pixel]) : near;
      far = std::max(far, image.t[pixel]);
    }
    const float step = (1 / (0.999f * near) - 1 / (1.001f * far)) / 65534;
    for (size_t pixel = 0; pixel < image.t.size(); ++pixel) {
      if (image.holds(pixel)) {
        EXPECT_NEAR(1 / back[i].image.t[pixel], 1 / image.t[pixel], 0.51f * step + 1e-7f);
        EXPECT_NEAR(srgbByteFromLinear(back[i].image.color[pixel].x), srgbByteFromLinear(image.color[pixel].x), 0);
      }
    }
  }
}

TEST(DepthViewsFolder, panoramasAreViews) {
  const TemporaryFolder folder;
  View view;
  view.eye = {0, 0, 1};
  view.fovVerticalDegrees = 60;
  const ReferenceImages panorama =
      buildReferenceImages(cameraChoice("panorama"), PinholeCamera(view, 64, 32), test::wall(-1));
  writeReferenceImages(folder / "p.exr", panorama);
  const std::vector<DepthView> views = readDepthViews(folder.path());
  ASSERT_EQ(views.size(), 1u);
  EXPECT_TRUE(views[0].image.isPlaced());
  EXPECT_THROW(writeDepthViews(folder / "png", views, depthViewsFormats()[1]), InputError);
}

TEST(DepthViewsFolder, whatIsMissingIsNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(readingError(folder / "none"), HasSubstr("there is no such folder"));
  EXPECT_THAT(readingError(folder.path()), HasSubstr("no views.json and no .exr files"));
  writeDepthViews(folder / "views", test::cornerViews(test::wall(0), 4), depthViewsFormats()[1]);
  std::filesystem::remove(folder / "views/v2_depth.png");
  EXPECT_THAT(readingError(folder / "views"), HasSubstr("v2_depth.png"));
}

TEST(DepthViewsFolder, depthsThatDoNotFitAreNamed) {
  const TemporaryFolder folder;
  const auto broken = folder / "views/v1_depth.png";
  writeDepthViews(folder / "views", test::cornerViews(test::wall(0), 4), depthViewsFormats()[1]);
  writeLevelPng(broken, Image<uint16_t>(kWidth, kHeight / 2, 7));
  EXPECT_THAT(readingError(folder / "views"), AllOf(HasSubstr("v1_depth.png"), HasSubstr("90x30"), HasSubstr("90x60")));
  writePng(broken, Image<Rgb8>(kWidth, kHeight, Rgb8(9)));
  EXPECT_THAT(readingError(folder / "views"), HasSubstr("8 bits a channel, and is not grey"));
  writeLevelPng(broken, Image<uint16_t>(kWidth, kHeight, 0));
  EXPECT_THAT(readingError(folder / "views"), AllOf(HasSubstr("v1_depth.png"), HasSubstr("no depth at any pixel")));
  folder.write("views/v1_depth.png", "no picture, though its name ends as one's");
  EXPECT_THAT(readingError(folder / "views"), HasSubstr("this is no PNG file"));
}

TEST(DepthViewsFolder, otherCamerasAndBrokenDepthsAreRefused) {
  const TemporaryFolder folder;
  writeReferenceImages(folder / "a.exr",
                       buildReferenceImages(cameraChoice("ldi-2"), test::smallCamera(), test::tiltedPlane(0.5f)));
  EXPECT_EQ(readingError(folder.path()), "");  // of one layer, it is a depth image
  ReferenceImages images{test::cornerViews(test::wall(0), 4)[0].image};
  images[0].displacement(45, 30) = {1, 0};
  writeReferenceImages(folder / "a.exr", images);
  EXPECT_THAT(readingError(folder.path()), AllOf(HasSubstr("a.exr"), HasSubstr("no view with depth")));
  images = {test::cornerViews(test::wall(0), 4)[0].image};
  images[0].t(45, 30) = std::numeric_limits<float>::quiet_NaN();
  writeReferenceImages(folder / "a.exr", images);
  EXPECT_THAT(readingError(folder.path()), AllOf(HasSubstr("a.exr"), HasSubstr("(45, 30)")));
}

TEST(DepthViewsFolder, twoViewsOfOnePlaceAreRefused) {
  const TemporaryFolder folder;
  const ReferenceImage image = test::cornerViews(test::wall(0), 4)[0].image;
  writeReferenceImages(folder / "a.exr", {image});
  writeReferenceImages(folder / "b.exr", {image});
  EXPECT_THAT(readingError(folder.path()), HasSubstr("views \"a\" and \"b\" have the same place and direction"));
}

TEST(DepthViewsFolder, aFolderWithViewsIsNotWrittenTo) {
  const TemporaryFolder folder;
  const std::vector<DepthView> views = test::cornerViews(test::wall(0), 4);
  writeDepthViews(folder / "views", views, depthViewsFormats()[0]);
  EXPECT_THROW(writeDepthViews(folder / "views", views, depthViewsFormats()[1]), InputError);
  folder.write("file", "");
  EXPECT_THROW(writeDepthViews(folder / "file", views, depthViewsFormats()[0]), WorkError);
}

}  // namespace
}  // namespace ocelli
