#include "oc_core/scene/text_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

PointCloud pointsOf(const std::string& text) {
  std::istringstream stream(text);
  return readTextPoints(stream, "cloud.xyz");
}

TEST(TextPoints, HavePositionsAlone) {
  const PointCloud cloud = pointsOf("# made by hand\n\n1 2 3\n  -4\t+5e-1,6 \r\n// the end\n7;8;9");
  EXPECT_EQ(cloud.positions, (std::vector<glm::vec3>{{1, 2, 3}, {-4, 0.5f, 6}, {7, 8, 9}}));
  EXPECT_TRUE(cloud.colors.empty());
  EXPECT_TRUE(cloud.normals.empty());
}

TEST(TextPoints, HaveColorsOrNormals) {
  const glm::vec3 grey(linearFromSrgbByte(128));
  const PointCloud colored = pointsOf("0 0 0 255 0 255\n1 1 1 128 128 128\n");
  EXPECT_EQ(colored.colors, (std::vector<glm::vec3>{{1, 0, 1}, grey}));
  EXPECT_TRUE(colored.normals.empty());
  const PointCloud directed = pointsOf("0 0 0 0 0 1\n1 1 1 0 0.6 -0.8\n2 2 2 1 0 0\n");
  EXPECT_EQ(directed.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 0.6f, -0.8f}, {1, 0, 0}}));
  EXPECT_TRUE(directed.colors.empty());
  // Whole numbers that are unit vectors everywhere are those of a floor or a box.
  const PointCloud floor = pointsOf("0 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 1 0\n");
  EXPECT_EQ(floor.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
  EXPECT_TRUE(floor.colors.empty());
  const PointCloud dark = pointsOf("0 0 0 0 0 1\n1 1 0 0 1 1\n0 1 0 0 0 1\n");
  EXPECT_EQ(dark.colors.size(), 3u);
  EXPECT_TRUE(dark.normals.empty());
  const PointCloud leica = pointsOf("2\n0 0 0 -1200 255 0 0\n1 1 1 0.5 128 128 128\n");
  EXPECT_EQ(leica.colors, (std::vector<glm::vec3>{{1, 0, 0}, grey}));
  const PointCloud both = pointsOf("0 0 0 255 255 255 0 -1 0\n");
  EXPECT_EQ(both.colors, (std::vector<glm::vec3>{{1, 1, 1}}));
  EXPECT_EQ(both.normals, (std::vector<glm::vec3>{{0, -1, 0}}));
  EXPECT_TRUE(pointsOf("1 2 3 0.5\n").colors.empty());
}

TEST(TextPoints, SayWhichLineIsWrong) {
  const auto read = [](const std::string& text) { return [text] { pointsOf(text); }; };
  EXPECT_THAT(read("1 2 3\n1 2 x\n"), ThrowsMessage<InputError>(AllOf(HasSubstr("line 2"), HasSubstr("\"x\""))));
  EXPECT_THAT(read("1 2 3\n1 2\n"), ThrowsMessage<InputError>(AllOf(HasSubstr("line 2"), HasSubstr("3 numbers"))));
  EXPECT_THAT(read("1 2 3\n1 2 3 4\n"), ThrowsMessage<InputError>(HasSubstr("line 2")));
  EXPECT_THAT(read("1 2 3 4 5\n"), ThrowsMessage<InputError>(HasSubstr("5 numbers")));
  EXPECT_THAT(read("1 2 3 4 5 6 7 8 9 10\n"), ThrowsMessage<InputError>(HasSubstr("more than 9")));
  EXPECT_THAT(read("1 2 3 0 256 0 0\n"), ThrowsMessage<InputError>(HasSubstr("0 to 255")));
  EXPECT_THAT(read("3\n1 2 3\n4 5 6\n"), ThrowsMessage<InputError>(AllOf(HasSubstr("3 points"), HasSubstr("has 2"))));
  EXPECT_THAT(read("1.5\n1 2 3\n"), ThrowsMessage<InputError>(HasSubstr("line 1")));
  EXPECT_THAT(read("99999999999999999999\n1 2 3\n"), ThrowsMessage<InputError>(HasSubstr("line 1")));
  EXPECT_THAT(read(std::string(5000, '1')), ThrowsMessage<InputError>(HasSubstr("too long")));
}

/// A file whose disk fails after its text.
class FailingBuffer final : public std::stringbuf {
 public:
  explicit FailingBuffer(const std::string& text) : std::stringbuf(text, std::ios_base::in) {}

 protected:
  int_type underflow() override {
    const int_type next = std::stringbuf::underflow();
    if (next == traits_type::eof()) {
      throw std::ios_base::failure("the disk failed");
    }
    return next;
  }
};

TEST(TextPoints, AreNotCutWhereReadingFails) {
  FailingBuffer buffer("1 2 3\n4 5 6\n");
  std::istream stream(&buffer);
  EXPECT_THAT([&] { readTextPoints(stream, "cloud.xyz"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("cannot be read"), HasSubstr("cloud.xyz, line 3"))));
  std::istringstream broken("1 2 3\n");
  broken.setstate(std::ios_base::badbit);
  EXPECT_THAT([&] { readTextPoints(broken, "cloud.xyz"); }, ThrowsMessage<InputError>(HasSubstr("cannot be read")));
  const test::TemporaryFolder folder;
  EXPECT_THAT([&] { readTextPoints(folder.path()); }, ThrowsMessage<InputError>(HasSubstr("cannot be read")))
      << "folders can be opened, but not read";
}

TEST(TextPoints, BecomeAScene) {
  const test::TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 100; ++i) {
    text += std::to_string(i % 10) + " " + std::to_string(i / 10) + " 0\n";
  }
  EXPECT_EQ(readSceneFile(folder.write("grid.XYZ", text)).points->panels, 100u);
  EXPECT_THROW(readSceneFile(folder.write("none.pts", "# nothing\n")), InputError);
  EXPECT_THAT([&] { readSceneFile(folder.write("nan.xyz", "0 0 0\nnan 1 2\n")); },
              ThrowsMessage<InputError>(HasSubstr("point 1")));
}

}  // namespace
}  // namespace ocelli
