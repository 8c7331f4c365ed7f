// PLY files of strips of triangles, as Stanford's and Georgia Tech's scans come.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>

#include "oc_core/base/error.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string kStripXyz = "property float x\nproperty float y\nproperty float z\n";

std::string stripHeader(const std::string& format, size_t vertices, size_t lists, const std::string& type) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) + "\n" + kStripXyz +
         "element tristrips " + std::to_string(lists) + "\nproperty list int " + type + " vertex_indices\nend_header\n";
}

Mesh readStrips(const std::string& text) {
  std::istringstream stream(text);
  return readPly(stream, text.size(), "strips.ply");
}

template <class Value>
void putRaw(std::string& bytes, Value value, bool bigEndian) {
  std::string raw(sizeof(value), '\0');
  std::memcpy(raw.data(), &value, sizeof(value));
  bytes += bigEndian ? std::string(raw.rbegin(), raw.rend()) : raw;
}

const std::string kSixPlaces = "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n";

TEST(PlyStrips, TurnEverySecondTriangleRound) {
  const Mesh mesh = readStrips(stripHeader("ascii", 6, 2, "int") + kSixPlaces + "5 0 1 2 3 4\n3 5 4 3\n");
  EXPECT_THAT(mesh.triangles,
              ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(2, 1, 3), glm::uvec3(2, 3, 4), glm::uvec3(5, 4, 3)));
}

TEST(PlyStrips, BeginAnewAtMinusOne) {
  // Strips of two and of no corners have no triangle, and the one after them begins as the first did.
  const Mesh mesh = readStrips(stripHeader("ascii", 6, 1, "int") + kSixPlaces + "14 -1 0 1 2 3 -1 4 5 -1 -1 2 3 4 5\n");
  EXPECT_THAT(mesh.triangles,
              ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(2, 1, 3), glm::uvec3(2, 3, 4), glm::uvec3(4, 3, 5)));
  EXPECT_EQ(readStrips(stripHeader("ascii", 6, 1, "uint") + kSixPlaces + "7 0 1 2 4294967295 3 4 5\n").triangles.size(),
            2u);
}

TEST(PlyStrips, TurnAtRepeatedCorners) {
  const Mesh mesh = readStrips(stripHeader("ascii", 6, 1, "int") + kSixPlaces + "6 0 1 2 2 3 4\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(3, 2, 4)));
}

/// A triangle with the same turn, whose smallest corner comes first.
std::array<uint32_t, 3> fromSmallest(const glm::uvec3& t) {
  std::array<uint32_t, 3> corners{t.x, t.y, t.z};
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

// A grid whose rows are strips of one list, in both byte orders, against its triangles, each cell by itself.
TEST(PlyStrips, AreTheTrianglesOfAGridInBothByteOrders) {
  constexpr uint32_t kWidth = 7;
  constexpr uint32_t kHeight = 5;
  for (const bool bigEndian : {false, true}) {
    std::string text =
        stripHeader(bigEndian ? "binary_big_endian" : "binary_little_endian", kWidth * kHeight, 1, "int");
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
      for (const uint32_t value : {i % kWidth, i / kWidth, 0U}) {
        putRaw(text, static_cast<float>(value), bigEndian);
      }
    }
    std::vector<int32_t> list;
    std::vector<std::array<uint32_t, 3>> expected;
    for (uint32_t y = 0; y + 1 < kHeight; ++y) {
      for (uint32_t x = 0; x < kWidth; ++x) {
        const uint32_t low = y * kWidth + x;
        list.push_back(static_cast<int32_t>(low));
        list.push_back(static_cast<int32_t>(low + kWidth));
        if (x + 1 < kWidth) {
          expected.push_back(fromSmallest({low, low + kWidth, low + 1}));
          expected.push_back(fromSmallest({low + 1, low + kWidth, low + kWidth + 1}));
        }
      }
      list.push_back(-1);
    }
    putRaw(text, static_cast<int32_t>(list.size()), bigEndian);
    for (const int32_t corner : list) {
      putRaw(text, corner, bigEndian);
    }
    std::vector<std::array<uint32_t, 3>> found;
    const Mesh mesh = readStrips(text);
    std::ranges::transform(mesh.triangles, std::back_inserter(found), fromSmallest);
    std::ranges::sort(found);
    std::ranges::sort(expected);
    EXPECT_EQ(found, expected);
    for (size_t size = 0; size < text.size(); ++size) {
      EXPECT_THROW(readStrips(text.substr(0, size)), InputError) << "truncated to " << size;
    }
  }
}

TEST(PlyStrips, MayStandBesideFaces) {
  std::string text = stripHeader("ascii", 6, 1, "int");
  text.insert(text.find("end_header"), "element face 1\nproperty list uchar int vertex_indices\n");
  EXPECT_THAT(readStrips(text + kSixPlaces + "3 0 1 2\n3 3 4 5\n").triangles,
              ElementsAre(glm::uvec3(0, 1, 2), glm::uvec3(3, 4, 5)));
}

TEST(PlyStrips, AreAScene) {
  const test::TemporaryFolder folder;
  const Scene scene =
      readSceneFile(folder.write("s.ply", stripHeader("ascii", 6, 1, "int") + kSixPlaces + "4 0 1 2 3\n"));
  EXPECT_FALSE(scene.points.has_value());
  EXPECT_EQ(scene.meshes[0].triangles.size(), 2u);
  EXPECT_EQ(scene.meshes[0].positions.size(), 4u) << "unused vertices are dropped";
}

// A scan has all of its strips in one list, longer than that of any face.
TEST(PlyStrips, MayBeVeryLong) {
  constexpr int32_t kCorners = (1 << 20) + 10;
  std::string text = stripHeader("binary_little_endian", 3, 1, "int");
  for (const float value : {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f}) {
    putRaw(text, value, false);
  }
  putRaw(text, kCorners, false);
  for (int32_t i = 0; i < kCorners; ++i) {
    putRaw(text, i % 3, false);
  }
  EXPECT_EQ(readStrips(text).triangles.size(), static_cast<size_t>(kCorners - 2));
}

TEST(PlyStrips, SayWhatIsWrong) {
  const auto expectStripError = [](const std::string& list, const std::string& message) {
    EXPECT_THAT([&] { readStrips(stripHeader("ascii", 6, 1, "int") + kSixPlaces + list); },
                ThrowsMessage<InputError>(testing::AllOf(HasSubstr("strips.ply"), HasSubstr(message))))
        << list;
  };
  expectStripError("3 0 1 6\n", "strip 0 names vertex 6 of 6");
  expectStripError("3 0 1 -2\n", "strip 0 names vertex -2 of 6");
  expectStripError("2 0 9\n", "vertex 9");  // also where it makes no triangle
  expectStripError("3 0 1 nan\n", "vertex nan");
  expectStripError("-3 0 1 2\n", "-3 entries");
  expectStripError("2000000000 0 1 2\n", "at tristrips 0 of 1");
  std::string noList = stripHeader("ascii", 6, 1, "int");
  noList.replace(noList.find("vertex_indices"), 14, "others");
  EXPECT_THAT([&] { readStrips(noList + kSixPlaces + "3 0 1 2\n"); },
              ThrowsMessage<InputError>(HasSubstr("the strips have no list")));
}

}  // namespace
}  // namespace ocelli
