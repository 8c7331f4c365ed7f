// Folders of images with poses: tables of positions, and COLMAP's text files.
#include "oc_core/sea_input/image_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/sea_input/image_file.h"
#include "oc_core/sea_input/place_table.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

void putImage(const fs::path& path, int width, int height, const Rgb8& color) {
  fs::create_directories(path.parent_path());
  writePng(path, Image<Rgb8>(width, height, color));
}

FolderImages opened(const TemporaryFolder& folder) {
  return {folder.path().string(), readImageFolder(folder.path())};
}

TEST(PositionFolder, HasOmnidirectionalImagesByName) {
  const TemporaryFolder folder;
  putImage(folder / "a.png", 32, 16, {1, 2, 3});
  putImage(folder / "more/b.png", 32, 16, {4, 5, 6});
  folder.write("positions.csv", "file,x,y,z,yaw,time\na.png,1,1.6,-2,0,9\nmore/b.png,2,1.6,-2.5,90,10\n");
  const FolderImages images = opened(folder);
  EXPECT_THAT(images.names(), ElementsAre("a.png", "more/b.png"));
  EXPECT_EQ(images.projection().width, 32);
  EXPECT_TRUE(images.projection().wraps());
  EXPECT_EQ(images.poses()[1].position, glm::dvec3(2, 1.6, -2.5));
  // A quarter of a turn to the left: what was ahead, -z, is now -x.
  const glm::dvec3 ahead = images.poses()[1].worldFromCamera * glm::dvec3(0, 0, -1);
  EXPECT_NEAR(ahead.x, -1, 1e-12);
  EXPECT_EQ(images.image(1)(3, 3), Rgb8(4, 5, 6));
}

TEST(PositionFolder, NamesWhatIsWrong) {
  const TemporaryFolder folder;
  putImage(folder / "a.png", 32, 16, {1, 2, 3});
  putImage(folder / "small.png", 16, 16, {1, 2, 3});
  const auto open = [&](const std::string& rows) {
    folder.write("positions.csv", "file,x,y,z\n" + rows);
    return [&folder] { opened(folder).image(1); };
  };
  EXPECT_THAT(open("a.png,1,2,3\na.png,1,2,3\n"), ThrowsMessage<InputError>(HasSubstr("same place")));
  EXPECT_THAT(open("a.png,1,2,3\nb.png,1,2,4\n"), ThrowsMessage<InputError>(HasSubstr("b.png")));
  EXPECT_THAT(open("a.png,1,2,3\nsmall.png,1,2,4\n"),
              ThrowsMessage<InputError>(AllOf(HasSubstr("small.png"), HasSubstr("16x16"), HasSubstr("32x16"))));
  EXPECT_THAT(open("a.png,1,nan,3\n"),
              ThrowsMessage<InputError>(AllOf(HasSubstr("positions.csv:2"), HasSubstr("nan"))));
  EXPECT_THAT(open("a.png,1e300,2,3\n"), ThrowsMessage<InputError>(HasSubstr("a.png")));
  EXPECT_THAT(open(""), ThrowsMessage<InputError>(HasSubstr("positions.csv")));
  folder.write("positions.csv", "x,y,z\n1,2,3\n");
  EXPECT_THAT([&] { opened(folder); }, ThrowsMessage<InputError>(HasSubstr("\"file\"")));
}

TEST(PlaceTable, TakesQuaternions) {
  const PlaceTable table = placesFromCsv("x,y,z,qw,qx,qy,qz\n0,0,0,0.7071068,0,0.7071068,0\n", "t.csv");
  const glm::dvec3 ahead = table.poses[0].worldFromCamera * glm::dvec3(0, 0, -1);
  EXPECT_NEAR(ahead.x, -1, 1e-6);
  EXPECT_TRUE(table.files.empty());
  const auto read = [](const std::string& text) { return [text] { placesFromCsv(text, "t.csv"); }; };
  EXPECT_THAT(read("x,y,z,qw,qx,qy,qz\n0,0,0,1,1,0,0\n"), ThrowsMessage<InputError>(HasSubstr("t.csv:2")));
  EXPECT_THAT(read("x,y,z,qw\n0,0,0,1\n"), ThrowsMessage<InputError>(HasSubstr("either yaw")));
  EXPECT_THAT(read("x,z\n0,0\n"), ThrowsMessage<InputError>(HasSubstr("\"y\"")));
  EXPECT_THAT(read(""), ThrowsMessage<InputError>(HasSubstr("empty")));
}

TEST(PosedImages, SaysWhatItShouldHold) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { readImageFolder(folder.path()); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("positions.csv"), HasSubstr("cameras.txt"))));
}

class ColmapFolder : public testing::Test {
 protected:
  ColmapFolder() {
    putImage(folder_ / "images/one.png", 64, 48, {9, 9, 9});
    putImage(folder_ / "images/two words.png", 64, 48, {8, 8, 8});
    fs::create_directories(folder_ / "sparse/0");
    cameras("# a comment\n1 PINHOLE 64 48 50 51 32 24\n");
    // The second camera stands at (1, 2, 3) and has turned by a quarter about y: COLMAP tells -R position.
    images("1 1 0 0 0 0 0 0 1 one.png\n1.5 2.5 -1 8 9 3\n2 0.70710678 0 0.70710678 0 -3 -2 1 1 two words.png\n\n");
  }
  void cameras(const std::string& text) { folder_.write("sparse/0/cameras.txt", text); }
  void images(const std::string& text) { folder_.write("sparse/0/images.txt", text); }

  TemporaryFolder folder_;
};

TEST_F(ColmapFolder, TurnsPosesIntoOurs) {
  folder_.write("sparse/0/points3D.txt", "# id\n7 1 2 3 255 0 0 0.5 1 0\n");
  const PosedImages folder = readImageFolder(folder_.path());
  EXPECT_EQ(folder.projection,
            (SeaProjection{SeaProjectionKind::kPinhole, 64, 48, glm::dvec2(50, 51), glm::dvec2(32, 24)}));
  EXPECT_THAT(folder.names, ElementsAre("one.png", "two words.png"));
  EXPECT_THAT(folder.points, ElementsAre(glm::dvec3(1, 2, 3)));
  // COLMAP: x right, y down, z forward.
  const SeaPose& first = folder.poses[0];
  EXPECT_EQ(first.position, glm::dvec3(0));
  EXPECT_NEAR(glm::distance(first.worldFromCamera * glm::dvec3(0, 0, -1), glm::dvec3(0, 0, 1)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(first.worldFromCamera * glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(folder.poses[1].position, glm::dvec3(1, 2, 3)), 0, 1e-6);
}

TEST_F(ColmapFolder, APointIsSeenWhereColmapSeesIt) {
  const PosedImages folder = readImageFolder(folder_.path());
  // By COLMAP's own rule: K (R p + t).
  const glm::dquat rotation(0.70710678, 0, 0.70710678, 0);
  const glm::dvec3 point = glm::dvec3(1, 2, 3) + glm::inverse(rotation) * glm::dvec3(0.3, -0.2, 2);
  const glm::dvec3 seen = rotation * point + glm::dvec3(-3, -2, 1);
  const glm::vec2 expected(50 * seen.x / seen.z + 32, 51 * seen.y / seen.z + 24);
  const SeaPose& pose = folder.poses[1];
  const auto pixel = folder.projection.pixel(glm::vec3(glm::inverse(pose.worldFromCamera) * (point - pose.position)));
  ASSERT_TRUE(pixel);
  EXPECT_LT(glm::distance(*pixel, expected), 1e-3f);
}

TEST_F(ColmapFolder, NamesWhatIsWrong) {
  const auto read = [&] { readImageFolder(folder_.path()); };
  cameras("1 OPENCV 64 48 50 51 32 24 0 0 0 0\n");
  EXPECT_THAT(read, ThrowsMessage<InputError>(AllOf(HasSubstr("cameras.txt:1"), HasSubstr("image_undistorter"))));
  cameras("1 PINHOLE 64 48 50 x 32 24\n");
  EXPECT_THAT(read, ThrowsMessage<InputError>(HasSubstr("\"x\" is no number")));
  cameras("1 SIMPLE_PINHOLE 64 48 50 32 24\n1 SIMPLE_PINHOLE 64 48 50 32 24\n");
  EXPECT_THAT(read, ThrowsMessage<InputError>(HasSubstr("twice")));
  cameras("1 SIMPLE_PINHOLE 64 48 50 32 24\n2 SIMPLE_PINHOLE 64 48 55 32 24\n");
  images("1 1 0 0 0 0 0 0 3 one.png\n\n");
  EXPECT_THAT(read, ThrowsMessage<InputError>(HasSubstr("no camera 3")));
  images("1 1 0 0 0 0 0 0 1 one.png\n\n2 1 0 0 0 0 0 1 2 two words.png\n\n");
  EXPECT_THAT(read, ThrowsMessage<InputError>(AllOf(HasSubstr("images.txt:3"), HasSubstr("of each camera"))));
  images("1 1 1 0 0 0 0 0 1 one.png\n\n");
  EXPECT_THAT(read, ThrowsMessage<InputError>(HasSubstr("no rotation")));
  images("1 1 0 0 0 0 0 0 1\n\n");
  EXPECT_THAT(read, ThrowsMessage<InputError>(HasSubstr("no name")));
}

TEST(ImageFile, TellsSizesOfWhatOthersWrote) {
  const TemporaryFolder folder;
  Image<Rgb8> image(37, 21, Rgb8(200, 100, 50));
  writePng(folder / "a.PNG", image);
  EXPECT_EQ(imageFileSize(folder / "a.PNG"), glm::ivec2(37, 21));
  EXPECT_EQ(readImageFile(folder / "a.PNG", {37, 21}), image);
  folder.write("b.png", "not a picture at all, but long enough");
  EXPECT_THAT([&] { imageFileSize(folder / "b.png"); }, ThrowsMessage<InputError>(HasSubstr("no png")));
  EXPECT_THAT([&] { imageFileSize(folder / "c.tiff"); }, ThrowsMessage<InputError>(HasSubstr("PNG or JPEG")));
  const ColorCodec* jpeg = findColorCodec("jpeg");
  if (jpeg == nullptr) {
    GTEST_SKIP() << "built without libjpeg";
  }
  const std::vector<std::byte> bytes = jpeg->encode(image, 90);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  folder.write("d.jpg", text);
  EXPECT_EQ(imageFileSize(folder / "d.jpg"), glm::ivec2(37, 21));
  EXPECT_NEAR(readImageFile(folder / "d.jpg", {37, 21})(5, 5).r, 200, 4);
  for (const size_t length : {0, 1, 5, 20, 100}) {
    folder.write("cut.jpg", text.substr(0, length));
    EXPECT_THROW(readImageFile(folder / "cut.jpg", {37, 21}), InputError) << length;
  }
}

}  // namespace
}  // namespace ocelli
