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
  writeReferenceImage(folder / "image.exr", image);
  const ReferenceImage back = readReferenceImage(folder / "image.exr");
  EXPECT_EQ(back.camera, image.camera);
  EXPECT_EQ(back.triangleBound, image.triangleBound);
  EXPECT_TRUE(test::sameBytes(back.color, image.color));
  EXPECT_TRUE(test::sameBytes(back.z, image.z));
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
    writeReferenceImage(folder / "image.exr", image);
    const ReferenceImage back = readReferenceImage(folder / "image.exr");
    EXPECT_TRUE(test::sameBytes(back.z, image.z)) << width << "x" << height;
    EXPECT_EQ(back.triangleBound, 0u);
  }
}

TEST(ReferenceImageFile, sameImageGivesTheSameBytes) {
  const TemporaryFolder folder;
  std::string first;
  for (const int threads : {1, 2, 8}) {
    setThreadCount(threads);
    writeReferenceImage(folder / "image.exr", ocri());
    const std::string bytes = fileBytes(folder / "image.exr");
    first = first.empty() ? bytes : first;
    EXPECT_EQ(bytes, first) << threads;
  }
  setThreadCount(0);
}

TEST(ReferenceImageFile, placesThatCannotBeWrittenAreWorkErrors) {
  const TemporaryFolder folder;
  const ReferenceImage image = buildDepthImage(smallCamera(), test::wall(0));
  EXPECT_THROW(writeReferenceImage(folder.path(), image), WorkError);
  EXPECT_THROW(writeReferenceImage(folder / "no/such/folder.exr", image), WorkError);
}

TEST(ReferenceImageFile, whatIsNoFileIsNamed) {
  const TemporaryFolder folder;
  for (const auto& path : {folder / "missing.exr", folder.path(), folder.write("empty.exr", ""),
                           folder.write("text.exr", "this is no image at all, whatever its name says"),
                           folder.write("magic.exr", std::string("\x76\x2f\x31\x01\x02\0\0\0", 8))}) {
    try {
      readReferenceImage(path);
      FAIL() << path;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(path.string()));
    }
  }
}

}  // namespace
}  // namespace ocelli
