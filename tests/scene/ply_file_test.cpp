#include "oc_core/scene/ply_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "oc_core/worlds/solids.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string asciiHeader(const std::string& colorType) {
  std::string header = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 3\n" + kXyz;
  for (const char* name : {"red", "green", "blue"}) {
    header += colorType.empty() ? "" : "property " + colorType + " " + name + "\n";
  }
  return header + kFaces;
}

template <class Value>
std::string bytesOf(Value value, bool bigEndian) {
  std::string bytes(sizeof(value), '\0');
  std::memcpy(bytes.data(), &value, sizeof(value));
  return bigEndian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

/// A red, a half green and a dark blue vertex.
template <class Color>
std::string binaryFile(const std::string& colorType, const std::array<std::array<Color, 3>, 3>& colors,
                       bool bigEndian) {
  std::string file = asciiHeader(colorType);
  file.replace(file.find("ascii"), 5, bigEndian ? "binary_big_endian" : "binary_little_endian");
  for (size_t i = 0; i < 3; ++i) {
    for (const float coordinate : {i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f, 0.5f}) {
      file += bytesOf(coordinate, bigEndian);
    }
    for (const Color channel : colors[i]) {
      file += bytesOf(channel, bigEndian);
    }
  }
  file += '\3';
  for (const int32_t corner : {0, 1, 2}) {
    file += bytesOf(corner, bigEndian);
  }
  return file;
}

void expectThreeColors(const Mesh& mesh) {
  ASSERT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0.5f));
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 2));
  ASSERT_EQ(mesh.colors.size(), 3u);
  constexpr float kByteStep = 0.5f / 255 * 2.3f;  // half an 8-bit step times the steepest slope of the sRGB curve
  EXPECT_NEAR(glm::distance(mesh.colors[0], {1, 0, 0}), 0.0f, kByteStep);
  EXPECT_NEAR(glm::distance(mesh.colors[1], {0, linearFromSrgb(0.5f), 0}), 0.0f, kByteStep);
  EXPECT_NEAR(glm::distance(mesh.colors[2], {0, 0, linearFromSrgb(0.25f)}), 0.0f, kByteStep);
}

TEST(ReadPly, TakesColorsOfEveryTypeAsSrgb) {
  const TemporaryFolder folder;
  const std::string ascii = asciiHeader("uchar") + "0 0 .5 255 0 0\n1 0 0.5 0 128 0\n0 1e0 +0.5 0 0 64\n3 0 1 2\n";
  expectThreeColors(readPly(folder.write("ascii.ply", ascii)));
  const std::string asciiFloat = asciiHeader("float") + "0 0 0.5 1 0 0\r\n1 0 0.5 0 .5 0\r\n0 1 0.5 0 0 .25\r\n3 0 1 2";
  expectThreeColors(readPly(folder.write("ascii_float.ply", asciiFloat)));
  for (const bool big : {false, true}) {
    expectThreeColors(readPly(
        folder.write("uchar.ply", binaryFile<uint8_t>("uchar", {{{255, 0, 0}, {0, 128, 0}, {0, 0, 64}}}, big))));
    expectThreeColors(readPly(
        folder.write("float.ply", binaryFile<float>("float", {{{1, 0, 0}, {0, 0.5f, 0}, {0, 0, 0.25f}}}, big))));
    expectThreeColors(readPly(
        folder.write("double.ply", binaryFile<double>("double", {{{1, 0, 0}, {0, 0.5, 0}, {0, 0, 0.25}}}, big))));
    expectThreeColors(readPly(folder.write(
        "ushort.ply", binaryFile<uint16_t>("uint16", {{{65535, 0, 0}, {0, 32768, 0}, {0, 0, 16384}}}, big))));
  }
}

TEST(ReadPly, ClampsColorsThatAreOutOfRange) {
  const TemporaryFolder folder;
  const Mesh mesh =
      readPly(folder.write("a.ply", asciiHeader("uchar") + "0 0 0 300 -7 nan\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n"));
  EXPECT_EQ(mesh.colors[0], glm::vec3(1, 0, 0));
}

TEST(ReadPly, SkipsWhatItDoesNotKnow) {
  const TemporaryFolder folder;
  const Mesh mesh = readPly(folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nobj_info x\nelement camera 1\nproperty list uchar float weights\nelement vertex "
      "3\nproperty "
      "float nx\n" +
          kXyz +
          "property list uchar int more\nelement face 2\nproperty list uchar int vertex_index\nproperty int flags\n" +
          "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n" +
          "2 0.5 0.5\n9 0 0 0 0\n9 1 0 0 1 5\n9 0 1 0 0\n3 0 1 2 7\n3 2 1 0 8\n0 1\n"));
  EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0));
  EXPECT_EQ(mesh.triangles[1], glm::uvec3(2, 1, 0));
  EXPECT_TRUE(mesh.colors.empty());
}

TEST(ReadPly, MakesFansOfPolygons) {
  const TemporaryFolder folder;
  const Mesh mesh = readPly(folder.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 5\n" + kXyz + kFaces +
                                                      "0 0 0\n2 0 0\n3 1 0\n1 2 0\n0 1 0\n5 0 1 2 3 4\n"));
  const std::vector<glm::uvec3> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  EXPECT_EQ(mesh.triangles, fan);
}

TEST(ReadPly, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string good = "0 0 0\n1 0 0\n0 1 0\n";
  const auto expectError = [&](const std::string& bytes, const std::string& message) {
    const fs::path path = folder.write("bad.ply", bytes);
    EXPECT_THAT([&] { readPly(path); },
                ThrowsMessage<InputError>(testing::AllOf(HasSubstr(path.string()), HasSubstr(message))))
        << bytes;
  };
  expectError("solid\n", "line 1: this does not start with 'ply'");
  expectError("ply\nformat ascii 1.0\nelement vertex 3\n", "ends within the header");
  expectError("ply\nformat text 1.0\nend_header\n", "unknown format 'text'");
  expectError("ply\nelement vertex 0\nend_header\n", "names no format");
  expectError("ply\nformat ascii 1.0\nelement vertex -3\nend_header\n", "'-3' is not a number");
  expectError("ply\nformat ascii 1.0\nproperty float x\nend_header\n", "before the first element");
  expectError("ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n", "unknown type 'real'");
  expectError("ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_indices\nend_header\n1\n",
              "not a whole number");
  expectError("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
              "do not have x, y and z");
  expectError("ply\nformat ascii 1.0\nelement vertex 1\n" + kXyz + "end_header\n0 0 0\n", "no faces");
  expectError(asciiHeader("") + good + "3 0 1 3\n", "face 0 names vertex 3 of 3");
  expectError(asciiHeader("") + good + "3 0 1 -1\n", "face 0 names vertex -1 of 3");
  expectError(asciiHeader("") + good + "3 0 1 nan\n", "face 0 names vertex nan of 3");
  expectError(asciiHeader("") + good + "-3 0 1 2\n", "-3 entries");
  expectError(asciiHeader("") + good + "3 0 1 x\n", "at face 0 of 1");
  expectError(asciiHeader("") + "0 0 0\n1 0,5 0\n0 1 0\n3 0 1 2\n", "at vertex 1 of 3");
}

TEST(ReadPly, FindsEveryTruncation) {
  const TemporaryFolder folder;
  const std::string whole = binaryFile<uint8_t>("uchar", {{{255, 0, 0}, {0, 128, 0}, {0, 0, 64}}}, false);
  ASSERT_NO_THROW(readPly(folder.write("whole.ply", whole)));
  for (size_t bytes = 0; bytes < whole.size(); ++bytes) {
    EXPECT_THROW(readPly(folder.write("cut.ply", whole.substr(0, bytes))), InputError) << bytes;
  }
}

TEST(ReadPly, TakesNoMemoryForWhatTheFileCannotHold) {
  const TemporaryFolder folder;
  for (const char* format : {"ascii", "binary_little_endian"}) {
    for (const char* count : {"999999999", "18446744073709551615", "99999999999999999999999"}) {
      EXPECT_THROW(readPly(folder.write("huge.ply", std::string("ply\nformat ") + format + " 1.0\nelement vertex " +
                                                        count + "\n" + kXyz + kFaces + "0 0 0\n")),
                   InputError);
    }
  }
}

TEST(ReadPly, SurvivesEveryFlippedByte) {
  const TemporaryFolder folder;
  const std::string whole = binaryFile<uint8_t>("uchar", {{{255, 0, 0}, {0, 128, 0}, {0, 0, 64}}}, false);
  size_t rejected = 0;
  for (size_t i = 0; i < whole.size(); ++i) {
    for (const char flip : {'\x01', '\x80', '\xff'}) {
      std::string broken = whole;
      broken[i] = static_cast<char>(broken[i] ^ flip);
      try {
        const Mesh mesh = readPly(folder.write("broken.ply", broken));
        for (const glm::uvec3& t : mesh.triangles) {
          EXPECT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
        }
      } catch (const InputError&) {
        ++rejected;
      }
    }
  }
  EXPECT_GT(rejected, whole.size()) << "most of a file this small is header";
}

TEST(WritePly, RoundTrips) {
  const TemporaryFolder folder;
  Mesh mesh = makeSphere(100);
  for (const glm::vec3& position : mesh.positions) {
    mesh.colors.push_back(position * 0.5f + 0.5f);
  }
  writePly(folder.path() / "a.ply", mesh);
  const Mesh back = readPly(folder.path() / "a.ply");
  EXPECT_EQ(back.positions, mesh.positions);
  EXPECT_EQ(back.triangles, mesh.triangles);
  ASSERT_EQ(back.colors.size(), mesh.colors.size());
  for (size_t i = 0; i < mesh.colors.size(); ++i) {
    for (glm::length_t channel = 0; channel < 3; ++channel) {
      EXPECT_EQ(srgbByteFromLinear(back.colors[i][channel]), srgbByteFromLinear(mesh.colors[i][channel]));
    }
  }
  writePly(folder.path() / "b.ply", back);
  EXPECT_EQ(test::fileBytes(folder / "a.ply"), test::fileBytes(folder / "b.ply"))
      << "bytes are stable once the colours are bytes";
}

TEST(WritePly, LeavesColorsOutWhereThereAreNone) {
  const TemporaryFolder folder;
  writePly(folder.path() / "a.ply", makeBox(glm::vec3(1)));
  EXPECT_TRUE(readPly(folder.path() / "a.ply").colors.empty());
}

TEST(WritePly, LeavesNothingBehindWhereItFails) {
  const TemporaryFolder folder;
  const Mesh box = makeBox(glm::vec3(1));
  const fs::path missing = folder.path() / "no_such_folder" / "a.ply";
  EXPECT_THAT([&] { writePly(missing, box); }, ThrowsMessage<WorkError>(HasSubstr(missing.string())));
  fs::create_directories(folder.path() / "is_a_folder" / "with_something");
  EXPECT_THROW(writePly(folder.path() / "is_a_folder", box), WorkError);
  EXPECT_TRUE(fs::is_directory(folder.path() / "is_a_folder"));
  size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder.path())) {
    ++entries;
  }
  EXPECT_EQ(entries, 1u);
}

TEST(WritePly, LeavesDevicesInTheirPlace) {
  const Mesh box = makeBox(glm::vec3(1));
  EXPECT_THAT([&] { writePly("/dev/full", box); }, ThrowsMessage<WorkError>(HasSubstr("/dev/full")));
  EXPECT_NO_THROW(writePly("/dev/null", box));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WritePly, FollowsALink) {
  const TemporaryFolder folder;
  folder.write("target.ply", "old");
  fs::create_symlink("target.ply", folder / "link.ply");
  writePly(folder / "link.ply", makeBox(glm::vec3(1)));
  EXPECT_TRUE(fs::is_symlink(folder / "link.ply"));
  EXPECT_EQ(readPly(folder / "target.ply").triangles.size(), 12u);
}

}  // namespace
}  // namespace ocelli
