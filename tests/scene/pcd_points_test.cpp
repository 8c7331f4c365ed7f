#include "oc_core/scene/pcd_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>
#include <sstream>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "oc_core/scene/lzf.h"
#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

PointCloud readCloud(const std::string& text) {
  std::istringstream stream(text);
  return readPcdPoints(stream, text.size(), "cloud.pcd");
}

std::string pcdHeader(const std::string& data, size_t points, const std::string& fields = "x y z",
                      const std::string& size = "4 4 4", const std::string& type = "F F F",
                      const std::string& count = "1 1 1") {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + size + "\nTYPE " +
         type + "\nCOUNT " + count + "\nWIDTH " + std::to_string(points) +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + std::to_string(points) + "\nDATA " + data + "\n";
}

template <class Value>
void putPcd(std::string& bytes, Value value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// Compressed by runs alone, and with copies where a byte repeats: LZF as the definition has it, without a search.
std::string lzf(const std::string& bytes) {
  std::string out;
  for (size_t i = 0; i < bytes.size();) {
    size_t same = 1;
    while (i + same < bytes.size() && bytes[i + same] == bytes[i] && same < 250) {
      ++same;
    }
    out += '\0';  // a run of one byte
    out += bytes[i];
    if (same >= 10) {
      const size_t length = same - 1;  // of the copy of what begins one byte back
      out += static_cast<char>(7 << 5);
      out += static_cast<char>(length - 9);
      out += '\0';
      i += same;
    } else {
      ++i;
    }
  }
  return out;
}

std::vector<std::byte> bytesOfText(const std::string& text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

TEST(Lzf, TakesRunsAndCopiesThatOverlap) {
  using namespace std::string_literals;
  // "abc", then 5 bytes from 3 back, then 20 from 1 back
  const auto result = lzfDecompressed(bytesOfText("\x02"s + "abc" + "\x60\x02"s + "\xe0\x0b\x00"s), 28);
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(*result, bytesOfText("abcabcab" + std::string(20, 'b')));
}

TEST(Lzf, RefusesWhatIsDamaged) {
  using namespace std::string_literals;
  const std::string good = "\x02"s + "abc" + "\x60\x02"s + "\xe0\x0b\x00"s;
  EXPECT_FALSE(lzfDecompressed(bytesOfText(good), 27).has_value());
  EXPECT_FALSE(lzfDecompressed(bytesOfText(good), 29).has_value());
  for (size_t size = 0; size < good.size(); ++size) {
    EXPECT_FALSE(lzfDecompressed(bytesOfText(good.substr(0, size)), 28).has_value()) << size;
  }
  EXPECT_FALSE(lzfDecompressed(bytesOfText("\x20\x00"s), 3).has_value()) << "a copy of what is not there";
  EXPECT_TRUE(lzfDecompressed({}, 0).has_value());
}

TEST(PcdPoints, AreReadFromAscii) {
  // 4.2108e+06 is no round colour; 16711680 is red as a whole number.
  const PointCloud cloud = readCloud(pcdHeader("ascii", 3, "x y z rgba", "4 4 4 4", "F F F U", "1 1 1 1") +
                                     "0.5 1 2 16711680\r\n\nnan nan nan 0\n-1 +2e0 3 4278255360\n");
  EXPECT_EQ(cloud.positions, (std::vector<glm::vec3>{{0.5f, 1, 2}, {-1, 2, 3}}));
  EXPECT_EQ(cloud.colors, (std::vector<glm::vec3>{{1, 0, 0}, {0, 1, 0}}));
  EXPECT_TRUE(cloud.normals.empty());
  std::ostringstream packed;
  packed.precision(9);
  packed << std::bit_cast<float>(0x00ff8000U);
  const PointCloud floats =
      readCloud(pcdHeader("ascii", 1, "x y z rgb", "4 4 4 4", "F F F F", "1 1 1 1") + "0 0 0 " + packed.str() + "\n");
  EXPECT_EQ(floats.colors, (std::vector<glm::vec3>{{1, linearFromSrgbByte(128), 0}}));
}

TEST(PcdPoints, NeedNoCountAndNoPoints) {
  const PointCloud cloud =
      readCloud("FIELDS z y x\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n1 2 3\n4 5 6\n");
  EXPECT_EQ(cloud.positions, (std::vector<glm::vec3>{{3, 2, 1}, {6, 5, 4}}));
}

/// Points with a field of three values before x, colours whose floats are no numbers, normals, and what is skipped.
struct MixedCloud {
  static constexpr size_t kPoints = 40;
  static std::string header(const std::string& data) {
    return pcdHeader(data, kPoints, "_ x y z rgb normal_x normal_y normal_z ring", "1 8 4 4 4 4 4 4 2",
                     "U F F F F F F F U", "3 1 1 1 1 1 1 1 1");
  }
  static float coordinate(size_t point) { return static_cast<float>(point) * 0.25f - 3; }
  /// One value of a field, as the file has it.
  static std::string field(size_t number, size_t point) {
    std::string bytes;
    if (number == 0) {
      bytes = "\x07\x08\x09";
    } else if (number == 1) {
      putPcd(bytes, static_cast<double>(coordinate(point)));
    } else if (number < 4) {
      putPcd(bytes, number == 2 ? 1.0f : static_cast<float>(point % 3));
    } else if (number == 4) {
      putPcd(bytes, uint32_t{0xff804020});
    } else if (number < 8) {
      putPcd(bytes, number == 7 ? 1.0f : 0.0f);
    } else {
      putPcd(bytes, uint16_t{5});
    }
    return bytes;
  }
  static void expect(const PointCloud& cloud) {
    ASSERT_EQ(cloud.positions.size(), kPoints);
    for (size_t i = 0; i < kPoints; ++i) {
      EXPECT_EQ(cloud.positions[i], glm::vec3(coordinate(i), 1, static_cast<float>(i % 3)));
      EXPECT_EQ(cloud.colors[i], glm::vec3(linearFromSrgbByte(128), linearFromSrgbByte(64), linearFromSrgbByte(32)));
      EXPECT_EQ(cloud.normals[i], glm::vec3(0, 0, 1));
    }
  }
};

TEST(PcdPoints, AreReadFromBinary) {
  std::string text = MixedCloud::header("binary");
  const size_t headerSize = text.size();
  for (size_t point = 0; point < MixedCloud::kPoints; ++point) {
    for (size_t field = 0; field < 9; ++field) {
      text += MixedCloud::field(field, point);
    }
  }
  MixedCloud::expect(readCloud(text));
  for (size_t size = headerSize; size < text.size(); ++size) {
    EXPECT_THROW(readCloud(text.substr(0, size)), InputError) << "truncated to " << size;
  }
}

TEST(PcdPoints, AreReadFromCompressed) {
  std::string values;
  for (size_t field = 0; field < 9; ++field) {
    for (size_t point = 0; point < MixedCloud::kPoints; ++point) {
      values += MixedCloud::field(field, point);
    }
  }
  const auto fileOf = [&](const std::string& compressed, size_t size) {
    std::string text = MixedCloud::header("binary_compressed");
    putPcd(text, static_cast<uint32_t>(compressed.size()));
    putPcd(text, static_cast<uint32_t>(size));
    return text + compressed;
  };
  const std::string compressed = lzf(values);
  ASSERT_NE(compressed.find('\xe0'), std::string::npos) << "it has a copy";
  const std::string text = fileOf(compressed, values.size());
  MixedCloud::expect(readCloud(text));
  for (size_t size = text.find("DATA"); size < text.size(); ++size) {
    EXPECT_THROW(readCloud(text.substr(0, size)), InputError) << "truncated to " << size;
  }
  EXPECT_THAT([&] { readCloud(fileOf(compressed, values.size() + 1)); },
              ThrowsMessage<InputError>(HasSubstr("not that of 40 points")));
  EXPECT_THAT([&] { readCloud(fileOf("\x20", values.size())); },
              ThrowsMessage<InputError>(HasSubstr("not that of 40 points")))
      << "more than so few bytes can stand for";
  EXPECT_THAT([&] { readCloud(fileOf(compressed.substr(0, compressed.size() - 1), values.size())); },
              ThrowsMessage<InputError>(HasSubstr("damaged")));
}

TEST(PcdPoints, SayWhatIsWrong) {
  const auto expectPcdError = [](const std::string& text, const std::string& message) {
    EXPECT_THAT([&] { readCloud(text); }, ThrowsMessage<InputError>(AllOf(HasSubstr("cloud.pcd"), HasSubstr(message))))
        << text;
  };
  expectPcdError("", "no line DATA");
  expectPcdError("solid\n", "line 1 is no line of a PCD header");
  expectPcdError("FIELDS x y\nSIZE 4 4\nTYPE F F\nWIDTH 1\nDATA ascii\n1 2\n", "do not have x, y and z");
  expectPcdError("FIELDS x y z\nSIZE 4 4\n", "SIZE does not have a value for each");
  expectPcdError("SIZE 4\n", "SIZE does not have a value for each");
  expectPcdError("FIELDS x y z\nSIZE 4 3 4\n", "'3' is no SIZE");
  expectPcdError("FIELDS x y z\nCOUNT 1 1 70000\n", "'70000' is no COUNT");
  expectPcdError("FIELDS x y z\nTYPE F F X\n", "must be F, I or U");
  expectPcdError("WIDTH -1\n", "WIDTH is not one whole number");
  expectPcdError("DATA zip\n", "DATA must be");
  expectPcdError(pcdHeader("ascii", 2) + "1 2 3\n", "too short for 2 points");
  expectPcdError(pcdHeader("ascii", 1) + "1 2\n", "line 12 does not have 3 numbers");
  expectPcdError(pcdHeader("ascii", 1) + "1 2 3 4\n", "line 12 does not have 3 numbers");
  expectPcdError(pcdHeader("ascii", 1) + "1 2 x\n", "line 12 does not have 3 numbers");
  expectPcdError(pcdHeader("binary", 20'000'001), "more than 20000000 points");
  expectPcdError(pcdHeader("binary", 20'000'000), "too short");
  expectPcdError("FIELDS x y z\nWIDTH 18446744073709551615\nHEIGHT 18446744073709551615\nDATA ascii\n", "impossible");
  expectPcdError(pcdHeader("ascii", 1, "x y z", "2 4 4"), "do not fit");
}

TEST(PcdPoints, BecomeAScene) {
  const test::TemporaryFolder folder;
  std::string text = pcdHeader("ascii", 400);
  for (int i = 0; i < 400; ++i) {
    text += std::to_string(i % 20) + " " + std::to_string(i / 20) + " 0\n";
  }
  const Scene scene = readSceneFile(folder.write("grid.PCD", text));
  ASSERT_TRUE(scene.points.has_value());
  EXPECT_EQ(scene.points->panels, 400u);
  EXPECT_THAT([&] { readSceneFile(folder.write("empty.pcd", pcdHeader("ascii", 0))); },
              ThrowsMessage<InputError>(HasSubstr("no point")));
}

}  // namespace
}  // namespace ocelli
