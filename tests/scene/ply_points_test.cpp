// PLY files of points.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

PointCloud readPoints(const std::string& text) {
  std::istringstream stream(text);
  return readPlyPoints(stream, text.size(), "points.ply");
}

std::string pointHeader(const std::string& format, size_t count, const std::string& properties) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(count) + "\n" + properties + "end_header\n";
}

const std::string kPointXyz = "property float x\nproperty float y\nproperty float z\n";

template <class Value>
void put(std::string& bytes, Value value, bool bigEndian) {
  std::string raw(sizeof(value), '\0');
  std::memcpy(raw.data(), &value, sizeof(value));
  bytes += bigEndian ? std::string(raw.rbegin(), raw.rend()) : raw;
}

TEST(PlyPoints, AreReadFromAscii) {
  const PointCloud cloud = readPoints(pointHeader("ascii", 2,
                                                  kPointXyz + "property float confidence\nproperty float intensity\n"
                                                              "property list uchar int labels\nproperty uchar red\n"
                                                              "property uchar green\nproperty uchar blue\n") +
                                      "1 2 3 0.9 0.5 2 7 8 255 0 128\n-4 5e-1 6 0.8 0.4 0 0 255 0\n");
  EXPECT_EQ(cloud.positions, (std::vector<glm::vec3>{{1, 2, 3}, {-4, 0.5f, 6}}));
  EXPECT_EQ(cloud.colors, (std::vector<glm::vec3>{{1, 0, linearFromSrgbByte(128)}, {0, 1, 0}}));
  EXPECT_TRUE(cloud.normals.empty());
}

TEST(PlyPoints, AreReadFromBothByteOrders) {
  for (const bool bigEndian : {false, true}) {
    std::string text =
        pointHeader(bigEndian ? "binary_big_endian" : "binary_little_endian", 2,
                    "property double x\nproperty double y\nproperty double z\nproperty short reflectance\n"
                    "property float nx\nproperty float ny\nproperty float nz\n");
    for (const double base : {1.0, 10.0}) {
      put(text, base, bigEndian);
      put(text, base + 0.5, bigEndian);
      put(text, -base, bigEndian);
      put(text, static_cast<int16_t>(-3), bigEndian);
      put(text, 0.0f, bigEndian);
      put(text, static_cast<float>(base), bigEndian);
      put(text, -1.0f, bigEndian);
    }
    const PointCloud cloud = readPoints(text);
    EXPECT_EQ(cloud.positions, (std::vector<glm::vec3>{{1, 1.5f, -1}, {10, 10.5f, -10}}));
    EXPECT_EQ(cloud.normals, (std::vector<glm::vec3>{{0, 1, -1}, {0, 10, -1}}));
    EXPECT_TRUE(cloud.colors.empty());
    for (size_t size = 0; size < text.size(); ++size) {
      EXPECT_THROW(readPoints(text.substr(0, size)), InputError) << "truncated to " << size;
    }
  }
}

TEST(PlyPoints, AreOnlyThoseOfFilesWithoutTriangles) {
  const TemporaryFolder folder;
  const std::string points = pointHeader("ascii", 3, kPointXyz);
  const std::string rows = "0 0 0\n1 0 0\n0 1 0\n";
  const auto withElement = [&](const std::string& element) {
    std::string text = points;
    return text.insert(text.find("end_header"), element) + rows;
  };
  const std::string list = "property list uchar int vertex_indices\n";
  EXPECT_TRUE(plyHoldsPoints(folder.write("a.ply", points + rows)));
  EXPECT_TRUE(plyHoldsPoints(folder.write("b.ply", withElement("element face 0\n" + list))));
  EXPECT_TRUE(plyHoldsPoints(folder.write("c.ply", withElement("element camera 1\nproperty float f\n") + "1\n")));
  EXPECT_FALSE(plyHoldsPoints(folder.write("d.ply", withElement("element tristrips 1\n" + list) + "3 0 1 2\n")));
  for (const char* empty : {"element face 0\n", "element tristrips 0\n"}) {
    for (const std::string& properties : {std::string(), list}) {
      const auto path = folder.write("e.ply", withElement(empty + properties));
      EXPECT_TRUE(plyHoldsPoints(path)) << empty;
      EXPECT_EQ(readPlyPoints(path).positions.size(), 3u) << empty;
      EXPECT_EQ(readSceneFile(path).points->points, 3u) << empty;
    }
  }
  // One of four vertices is unused.
  std::string mesh = pointHeader("ascii", 4, kPointXyz);
  mesh.insert(mesh.find("end_header"), "element face 1\n" + list);
  const auto path = folder.write("mesh.ply", mesh + rows + "9 9 9\n3 0 1 2\n");
  EXPECT_FALSE(plyHoldsPoints(path));
  const Scene scene = readSceneFile(path);
  EXPECT_FALSE(scene.points.has_value());
  EXPECT_EQ(scene.meshes[0].positions.size(), 3u);
}

TEST(PlyPoints, BecomeAScene) {
  const TemporaryFolder folder;
  std::string text =
      pointHeader("ascii", 400, kPointXyz + "property uchar red\nproperty uchar green\nproperty uchar blue\n");
  for (int i = 0; i < 400; ++i) {
    text += std::to_string(i % 20) + " " + std::to_string(i / 20) + " 0 255 0 0\n";
  }
  const Scene scene = readSceneFile(folder.write("grid.ply", text));
  ASSERT_TRUE(scene.points.has_value());
  EXPECT_EQ(scene.points->panels, 400u);
  EXPECT_NEAR(scene.points->medianWidth, 1.15, 1e-4) << "a cell, and what they overlap";
  EXPECT_EQ(triangleCount(scene), 800u);
  EXPECT_EQ(scene.meshes[0].color(5), glm::vec3(1, 0, 0));
  EXPECT_NEAR(readSceneFile(folder / "grid.ply", {.points = {.width = 3}}).points->medianWidth, 3, 1e-5);
}

TEST(PlyPoints, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& text) { return [&, text] { readSceneFile(folder.write("x.ply", text)); }; };
  EXPECT_THAT(read(pointHeader("ascii", 0, kPointXyz)), ThrowsMessage<InputError>(HasSubstr("no points")));
  EXPECT_THAT(read(pointHeader("ascii", 1, kPointXyz) + "1 2 3\n"),
              ThrowsMessage<InputError>(HasSubstr("--point-size")));
  EXPECT_THAT(read(pointHeader("ascii", 3, kPointXyz) + "1 2 3\n1 2 3\n1 2 3\n"),
              ThrowsMessage<InputError>(HasSubstr("at one place")));
  EXPECT_THAT(read(pointHeader("ascii", 3, kPointXyz) + "1 2 3\n4 nan 6\n7 8 9\n"),
              ThrowsMessage<InputError>(HasSubstr("point 1 has a coordinate")));
  EXPECT_THAT(read(pointHeader("ascii", 3, kPointXyz) + "1.5 2.5 3.5\n4 5 6\n7 8\n"),
              ThrowsMessage<InputError>(AllOf(HasSubstr("vertex 2 of 3"), HasSubstr("x.ply"))));
  EXPECT_THAT(read(pointHeader("ascii", 1'000'000'000'000, kPointXyz) + "1 2 3\n"),
              ThrowsMessage<InputError>(HasSubstr("too short")));
  EXPECT_THAT(read(pointHeader("ascii", 2, "property float x\nproperty float y\n") + "1 2\n3 4\n"),
              ThrowsMessage<InputError>(HasSubstr("x, y and z")));
  // Rows without bytes, of which a file may tell any number.
  EXPECT_THROW(readSceneFile(folder.write("y.ply", pointHeader("ascii", 4'000'000'000, ""))), InputError);
}

}  // namespace
}  // namespace ocelli
