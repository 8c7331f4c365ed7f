#include "oc_core/ocri/reference_image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "tests/base/temporary_folder.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::fileBytes;
using test::smallCamera;
using test::TemporaryFolder;
using ::testing::HasSubstr;

ReferenceImage ocri() {
  const Mesh mesh = test::boxBeforeWall();
  return buildDdocImage(buildDdocCamera(smallCamera(), mesh), mesh);
}

TEST(ReferenceImageFile, readsBackBitForBit) {
  const TemporaryFolder folder;
  ReferenceImage image = ocri();
  image.camera = "a \"quoted\" name";
  writeReferenceImages(folder / "image.exr", {image});
  const ReferenceImages images = readReferenceImages(folder / "image.exr");
  ASSERT_EQ(images.size(), 1u);
  const ReferenceImage& back = images[0];
  EXPECT_EQ(back.camera, image.camera);
  EXPECT_EQ(back.triangleBound, image.triangleBound);
  EXPECT_TRUE(test::sameBytes(back.color, image.color));
  EXPECT_TRUE(test::sameBytes(back.t, image.t));
  EXPECT_TRUE(test::sameBytes(back.displacement, image.displacement));
  View resolved = image.view;
  resolved.fovVerticalDegrees = image.view.resolvedFovVerticalDegrees();
  EXPECT_EQ(back.view, resolved);
  EXPECT_EQ(back.reference().unproject({20.25f, 40.5f, 9}), image.reference().unproject({20.25f, 40.5f, 9}));
}

TEST(ReferenceImageFile, unusualSizesReadBack) {
  const TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair(1, 1), {1, 37}, {37, 1}, {17, 33}, {300, 200}}) {
    const ReferenceImage image = buildDepthImage(PinholeCamera(View{}, width, height), test::wall(0));
    writeReferenceImages(folder / "image.exr", {image});
    const ReferenceImage back = readReferenceImages(folder / "image.exr").at(0);
    EXPECT_TRUE(test::sameBytes(back.t, image.t)) << width << "x" << height;
    EXPECT_EQ(back.triangleBound, 0u);
  }
}

TEST(ReferenceImageFile, unionReadsBackPartByPart) {
  const TemporaryFolder folder;
  ReferenceImage shifted = buildDepthImage(PinholeCamera(View{}, 40, 20), test::wall(0));
  shifted.camera = "other";
  shifted.pinholeSize = {20, 40};
  shifted.rows = ImageRows::kShiftedRing;
  ReferenceImage tiled = shifted;
  tiled.rows = ImageRows::kShifted;
  tiled.tileSide = 8;
  tiled.tileSpacing = 1.25f;
  tiled.seenFromAside = true;
  const ReferenceImages images{ocri(), shifted, tiled};
  writeReferenceImages(folder / "union.exr", images);
  const ReferenceImages back = readReferenceImages(folder / "union.exr");
  ASSERT_EQ(back.size(), images.size());
  for (size_t i = 0; i < images.size(); ++i) {
    EXPECT_EQ(back[i].camera, images[i].camera);
    EXPECT_EQ(back[i].pinholeSize, images[i].pinholeSize);
    EXPECT_EQ(back[i].rows, images[i].rows);
    EXPECT_EQ(back[i].tileSide, images[i].tileSide);
    EXPECT_EQ(back[i].tileSpacing, images[i].tileSpacing);
    EXPECT_EQ(back[i].seenFromAside, images[i].seenFromAside);
    EXPECT_EQ(back[i].reference().focalPixels(), images[i].reference().focalPixels());
    EXPECT_TRUE(test::sameBytes(back[i].t, images[i].t));
    EXPECT_TRUE(test::sameBytes(back[i].displacement, images[i].displacement));
  }
}

TEST(ReferenceImageFile, sameImageGivesTheSameBytes) {
  const TemporaryFolder folder;
  std::string first;
  for (const int threads : {1, 2, 8}) {
    setThreadCount(threads);
    writeReferenceImages(folder / "image.exr", {ocri()});
    const std::string bytes = fileBytes(folder / "image.exr");
    first = first.empty() ? bytes : first;
    EXPECT_EQ(bytes, first) << threads;
  }
  setThreadCount(0);
}

TEST(ReferenceImageFile, placesThatCannotBeWrittenAreWorkErrors) {
  const TemporaryFolder folder;
  const ReferenceImage image = buildDepthImage(smallCamera(), test::wall(0));
  EXPECT_THROW(writeReferenceImages(folder.path(), {image}), WorkError);
  EXPECT_THROW(writeReferenceImages(folder / "no/such/folder.exr", {image}), WorkError);
}

TEST(ReferenceImageFile, whatIsNoFileIsNamed) {
  const TemporaryFolder folder;
  for (const auto& path : {folder / "missing.exr", folder.path(), folder.write("empty.exr", ""),
                           folder.write("text.exr", "this is no image at all, whatever its name says"),
                           folder.write("magic.exr", std::string("\x76\x2f\x31\x01\x02\0\0\0", 8))}) {
    try {
      readReferenceImages(path);
      FAIL() << path;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(path.string()));
    }
  }
}

}  // namespace
}  // namespace ocelli
