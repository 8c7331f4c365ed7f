#include "oc_core/ray_map/ray_map_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/image/exr_writer.h"
#include "tests/base/temporary_folder.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/camera/test_ray_maps.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Coordinates of 10, and those of 1000 at the far ends, are rounded to 32 bits: that of an end is its segment's
/// origin, direction and length.
void expectSameRays(const RayMap& got, const RayMap& want) {
  ASSERT_EQ(got.width(), want.width());
  ASSERT_EQ(got.height(), want.height());
  EXPECT_EQ(got.rayCount(), want.rayCount());
  EXPECT_EQ(got.maxSegments(), want.maxSegments());
  for (int y = 0; y < want.height(); ++y) {
    for (int x = 0; x < want.width(); ++x) {
      const RayMapRay a = got.ray(x, y);
      const RayMapRay b = want.ray(x, y);
      ASSERT_EQ(a.points.size(), b.points.size()) << x << ", " << y;
      for (size_t i = 0; i < a.points.size(); ++i) {
        const bool isEnd = i + 1 == a.points.size();
        const float rounding = isEnd ? 1e-6f * (1 + glm::length(b.points[i])) : 0;
        EXPECT_LE(glm::distance(a.points[i], b.points[i]), rounding) << x << ", " << y << ", point " << i;
        EXPECT_EQ(a.parameters[i], b.parameters[i]) << x << ", " << y << ", point " << i;
      }
    }
  }
}

TEST(RayMapFile, straightAndBentRaysComeBack) {
  for (const RayMap& map : {mapOfCamera(smallCamera()), mapOfCamera(crossroads()), mapOfCamera(bendingTwice()),
                            fisheyeMap(31), pushBroomMap({20, 9})}) {
    expectSameRays(rayMapFromBytes(rayMapBytes(map), "map.exr"), map);
  }
}

TEST(RayMapFile, notesComeBack) {
  RayMapNotes notes{.name = "lens \"8\"", .frame = RayFrame::kView, .view = View{}, .wrapsAround = true};
  notes.view->eye = {1, 2, 3};
  notes.view->fovVerticalDegrees = 40;
  const TemporaryFolder folder;
  const auto file = folder / "lens.exr";
  writeRayMap(file, mapOfCamera(smallCamera(), notes));
  const RayMap map = readRayMap(file);
  EXPECT_EQ(map.notes().name, "lens \"8\"");
  EXPECT_EQ(map.notes().frame, RayFrame::kView);
  EXPECT_TRUE(map.notes().wrapsAround);
  EXPECT_EQ(map.notes().view, notes.view);
  const RayMapHeader header = readRayMapHeader(file);
  EXPECT_EQ(header.size, glm::ivec2(kWidth, kHeight));
  EXPECT_EQ(header.notes.name, map.notes().name);
  EXPECT_TRUE(holdsRays(file));
}

/// Points may be nearer to each other than coordinates are rounded, while t goes on.
TEST(RayMapFile, segmentsWithoutALengthComeBack) {
  const RayMap map = RayMap::ofPolylines({1, 1}, {3}, {{5, 0, 0}, {5, 0, 0}, {5, 1, 0}}, {1, 2, 3}, {}, "test");
  expectSameRays(rayMapFromBytes(rayMapBytes(map), "map.exr"), map);
}

// ---- files of other programs

/// What another program has of each pixel.
struct ForeignRays {
  int width = 2;
  int height = 1;
  std::vector<glm::vec3> origins{{0, 0, 1}, {0.5f, 0, 1}};
  std::vector<glm::vec3> directions{{0, 0, -2}, {0, 0.3f, -1}};
  std::vector<float> lengths = {};
  std::vector<float> begins = {};
  std::vector<float> ends = {};
};

std::vector<ExrChannel> channelsOf(const ForeignRays& rays) {
  std::vector<ExrChannel> channels{{"origin.x", &rays.origins[0].x, sizeof(glm::vec3)},
                                   {"origin.y", &rays.origins[0].y, sizeof(glm::vec3)},
                                   {"origin.z", &rays.origins[0].z, sizeof(glm::vec3)},
                                   {"direction.x", &rays.directions[0].x, sizeof(glm::vec3)},
                                   {"direction.y", &rays.directions[0].y, sizeof(glm::vec3)},
                                   {"direction.z", &rays.directions[0].z, sizeof(glm::vec3)}};
  if (!rays.lengths.empty()) {
    channels.push_back({"length", rays.lengths.data(), sizeof(float)});
  }
  if (!rays.begins.empty()) {
    channels.push_back({"t.begin", rays.begins.data(), sizeof(float)});
  }
  if (!rays.ends.empty()) {
    channels.push_back({"t.end", rays.ends.data(), sizeof(float)});
  }
  return channels;
}

std::string foreignBytes(const std::vector<ForeignRays>& parts, const std::string& description = "") {
  std::vector<ExrPart> written;
  for (const ForeignRays& rays : parts) {
    written.push_back({fmt::format("{}", written.size()), rays.width, rays.height, channelsOf(rays), description});
  }
  return exrBytes(written);
}

std::string errorOf(const std::string& bytes) {
  try {
    rayMapFromBytes(bytes, "x/foreign.exr");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string kPlain = R"({"type": "rays", "format": 1})";

TEST(RayMapFile, originsAndDirectionsAreEnough) {
  const RayMap map = rayMapFromBytes(foreignBytes({ForeignRays{}}, kPlain), "x/foreign.exr");
  EXPECT_EQ(map.notes().name, "foreign") << "that of the file";
  EXPECT_EQ(map.notes().frame, RayFrame::kWorld);
  const RayPath ray = map.ray(0, 0).path();
  ASSERT_EQ(ray.size(), 2u);
  EXPECT_EQ(ray.front(), glm::vec3(0, 0, 1));
  EXPECT_EQ(ray.back(), glm::vec3(0, 0, 1 - RayMap::kDefaultFar));
  EXPECT_EQ(ray.tMax(), RayMap::kDefaultFar);
  const RayMap bounded = rayMapFromBytes(
      foreignBytes({ForeignRays{}}, R"({"type": "rays", "format": 1, "near": 0.5, "far": 3})"), "foreign.exr");
  EXPECT_EQ(bounded.ray(0, 0).path().front(), glm::vec3(0, 0, 0.5f));
  EXPECT_EQ(bounded.ray(0, 0).path().back(), glm::vec3(0, 0, -2));
}

TEST(RayMapFile, lengthsEndRays) {
  ForeignRays rays;
  rays.lengths = {2, 4};
  const RayMap map = rayMapFromBytes(foreignBytes({rays}, kPlain), "foreign.exr");
  EXPECT_EQ(map.ray(0, 0).path().back(), glm::vec3(0, 0, -1));
  EXPECT_EQ(map.ray(1, 0).path().tMax(), 4) << "t is the length, where the file says nothing else";
  rays.begins = {1, 1};
  rays.ends = {7, 8};
  EXPECT_EQ(rayMapFromBytes(foreignBytes({rays}, kPlain), "foreign.exr").ray(1, 0).path().tMax(), 8);
}

TEST(RayMapFile, segmentsJoinToPolylines) {
  ForeignRays first;
  first.lengths = {2, 4};
  ForeignRays second;
  second.origins = {{0, 0, -1}, {kNan, 0, 0}};
  second.directions = {{1, 0, 0}, {0, 0, 0}};
  second.lengths = {3, 0};
  const RayMap map = rayMapFromBytes(foreignBytes({first, second}, kPlain), "foreign.exr");
  EXPECT_EQ(map.maxSegments(), 2u);
  const RayPath bent = map.ray(0, 0).path();
  ASSERT_EQ(bent.size(), 3u);
  EXPECT_EQ(bent[2], glm::vec3(3, 0, -1));
  EXPECT_EQ(bent.t(1), 2);
  EXPECT_EQ(bent.t(2), 5);
  EXPECT_EQ(map.ray(1, 0).path().size(), 2u);
}

TEST(RayMapFile, brokenFilesSayWhatAndWhere) {
  EXPECT_THAT(errorOf(""), AllOf(HasSubstr("foreign.exr"), HasSubstr("does not start like one")));
  EXPECT_THAT(errorOf("PNG and something"), HasSubstr("does not start like one"));
  const std::string whole = foreignBytes({ForeignRays{}}, kPlain);
  EXPECT_EQ(errorOf(whole), "");
  for (size_t size = 0; size < whole.size(); size += 7) {
    EXPECT_NE(errorOf(whole.substr(0, size)), "") << size << " bytes of " << whole.size();
  }
  EXPECT_THAT(errorOf(foreignBytes({ForeignRays{}}, R"({"format": 1, "camera": "di"})")),
              HasSubstr("this is a reference image"));
  EXPECT_THAT(errorOf(foreignBytes({ForeignRays{}}, R"({"type": "ray"})")), HasSubstr("\"type\""));
  EXPECT_THAT(errorOf(foreignBytes({ForeignRays{}}, R"({"type": "rays", "format": 2})")), HasSubstr("\"format\""));
  EXPECT_THAT(errorOf(foreignBytes({ForeignRays{}}, R"({"type": "rays", "format": 1, "frame": "moon"})")),
              HasSubstr("\"frame\""));
  EXPECT_THAT(errorOf(foreignBytes({ForeignRays{}}, R"({"type": "rays", "format": 1, "near": 3, "far": 2})")),
              HasSubstr("\"far\""));
  EXPECT_THAT(errorOf(foreignBytes({ForeignRays{}}, R"({"type": "rays", "format": 1, "fov": 3})")),
              HasSubstr("\"fov\" is unknown"));
  EXPECT_THAT(errorOf(foreignBytes({ForeignRays{}}, "{")), HasSubstr("attribute \"ocelli\""));
}

TEST(RayMapFile, missingChannelsAreNamed) {
  ForeignRays rays;
  for (size_t left = 0; left < 6; ++left) {
    std::vector<ExrChannel> channels = channelsOf(rays);
    const std::string name = channels[left].name;
    channels.erase(channels.begin() + static_cast<std::ptrdiff_t>(left));
    EXPECT_THAT(errorOf(exrBytes({{"0", 2, 1, channels, kPlain}})), HasSubstr("no channel \"" + name + "\""));
  }
  std::vector<ExrChannel> whole = channelsOf(rays);
  whole[4].isWhole = true;
  EXPECT_THAT(errorOf(exrBytes({{"0", 2, 1, whole, kPlain}})), HasSubstr("\"direction.y\" has no 32-bit float"));
  rays.begins = {0, 0};
  EXPECT_THAT(errorOf(foreignBytes({rays}, kPlain)), HasSubstr("\"t.end\""));
  rays.ends = {1, 1};
  EXPECT_THAT(errorOf(foreignBytes({rays}, kPlain)), HasSubstr("no length"));
  rays.lengths = {1, 1};
  EXPECT_EQ(errorOf(foreignBytes({rays}, kPlain)), "");
  EXPECT_THAT(errorOf(foreignBytes({rays}, R"({"type": "rays", "format": 1, "far": 9})")), HasSubstr("leave one"));
  EXPECT_THAT(errorOf(foreignBytes({rays, ForeignRays{}}, kPlain)),
              AllOf(HasSubstr("part 1"), HasSubstr("no channel \"length\"")));
}

TEST(RayMapFile, raysThatAreNoneAreRefused) {
  ForeignRays none;
  none.origins.assign(2, glm::vec3(kNan));
  EXPECT_THAT(errorOf(foreignBytes({none}, kPlain)), HasSubstr("no pixel of the ray map has a ray"));
  ForeignRays still;
  still.directions.assign(2, glm::vec3(0));
  EXPECT_THAT(errorOf(foreignBytes({still}, kPlain)), HasSubstr("no pixel of the ray map has a ray"));
  still.lengths = {1, 1};
  EXPECT_THAT(errorOf(foreignBytes({still}, kPlain)), HasSubstr("no pixel of the ray map has a ray"));
  for (const float length : {0.0f, -1.0f, kNan, std::numeric_limits<float>::infinity()}) {
    ForeignRays rays;
    rays.lengths = {1, length};
    EXPECT_THAT(errorOf(foreignBytes({rays}, kPlain)), AllOf(HasSubstr("pixel (1, 0)"), HasSubstr("length")));
  }
  ForeignRays backward;
  backward.lengths = {1, 1};
  backward.begins = {0, 5};
  backward.ends = {1, 5};
  EXPECT_THAT(errorOf(foreignBytes({backward}, kPlain)), AllOf(HasSubstr("pixel (1, 0)"), HasSubstr("does not grow")));
}

TEST(RayMapFile, segmentsThatDoNotJoinAreRefused) {
  ForeignRays first;
  first.lengths = {2, 4};
  ForeignRays second = first;
  EXPECT_THAT(errorOf(foreignBytes({first, second}, kPlain)),
              AllOf(HasSubstr("segment 1 of the ray of pixel (0, 0)"), HasSubstr("does not begin where")));
  first.directions[1] = glm::vec3(0);
  second.origins[0] = {0, 0, -1};
  EXPECT_THAT(errorOf(foreignBytes({first, second}, kPlain)),
              AllOf(HasSubstr("segment 1 of the ray of pixel (1, 0)"), HasSubstr("follows no segment")));
  ForeignRays larger;
  larger.height = 2;
  larger.origins.resize(4);
  larger.directions.resize(4, glm::vec3(0));
  larger.lengths.resize(4, 1);
  EXPECT_THAT(errorOf(foreignBytes({first, larger}, kPlain)), AllOf(HasSubstr("part 1"), HasSubstr("2x2")));
}

/// A header that promises far more than the file holds must not take memory for it.
TEST(RayMapFile, hugeImagesOfSmallFilesAreRefused) {
  std::string bytes = foreignBytes({ForeignRays{}}, kPlain);
  const auto setWindow = [&](int32_t right, int32_t lower) {
    std::string changed = bytes;
    const size_t at = changed.find(std::string("dataWindow\0box2i\0\x10\0\0\0", 21)) + 21;
    std::memcpy(&changed[at + 8], &right, 4);
    std::memcpy(&changed[at + 12], &lower, 4);
    return changed;
  };
  EXPECT_EQ(errorOf(setWindow(1, 0)), "") << "the place of the window is found";
  EXPECT_THAT(errorOf(setWindow(8191, 8191)), HasSubstr("too short for the 8192x8192"));
  EXPECT_THAT(errorOf(setWindow(1 << 20, 1 << 20)), HasSubstr("2^26"));
  EXPECT_THAT(errorOf(setWindow(2147483647, 2147483647)), HasSubstr("foreign.exr"));
  EXPECT_THAT(errorOf(setWindow(-1, 0)), HasSubstr("foreign.exr"));
}

/// Any byte of the file may be wrong: a ray map or an error, and nothing else.
TEST(RayMapFile, flippedBytesDoNoHarm) {
  const std::string whole = foreignBytes({ForeignRays{}}, kPlain);
  int refused = 0;
  for (size_t i = 0; i < whole.size(); ++i) {
    for (const int flip : {1, 0x80}) {
      std::string changed = whole;
      changed[i] = static_cast<char>(changed[i] ^ flip);
      refused += errorOf(changed).empty() ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace ocelli::test
