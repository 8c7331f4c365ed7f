#include "oc_core/camera/ray_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/error.h"
#include "tests/camera/test_ray_maps.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const std::vector<glm::vec3> kOrigins{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, kNan}};
const std::vector<glm::vec3> kDirections{{0, 0, -2}, {0, 0, 0}, {0, kNan, -1}, {0, 0, -1}};

std::string errorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

RayMap fromArrays(const glm::ivec2& size, const std::vector<glm::vec3>& origins,
                  const std::vector<glm::vec3>& directions, float near = 0, float far = 5) {
  return RayMap::ofStraightRays(size, origins, directions, near, far, {}, "arrays");
}

TEST(RayMap, takesArraysInMemory) {
  const RayMap map = fromArrays({2, 2}, kOrigins, kDirections, 1, 5);
  EXPECT_EQ(map.rayCount(), 1u) << "directions of 0 and numbers that are none mean no ray";
  EXPECT_EQ(map.maxSegments(), 1u);
  const RayPath ray = map.ray(0, 0).path();
  ASSERT_EQ(ray.size(), 2u);
  EXPECT_EQ(ray.front(), glm::vec3(0, 0, -1)) << "directions of any length";
  EXPECT_EQ(ray.back(), glm::vec3(0, 0, -5));
  EXPECT_EQ(ray.tMin(), 1);
  EXPECT_EQ(ray.tMax(), 5);
  for (const glm::ivec2 pixel : {glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)}) {
    EXPECT_TRUE(map.ray(pixel.x, pixel.y).empty());
  }
}

TEST(RayMap, refusesArraysThatAreNoRays) {
  EXPECT_THAT(errorOf([] { fromArrays({2, 1}, kOrigins, kDirections); }), HasSubstr("4 origins and 4 directions"));
  EXPECT_THAT(errorOf([] { fromArrays({0, 4}, kOrigins, kDirections); }), HasSubstr("0x4"));
  EXPECT_THAT(errorOf([] { fromArrays({1 << 15, 1 << 15}, kOrigins, kDirections); }), HasSubstr("2^26"));
  EXPECT_THAT(errorOf([] { fromArrays({2, 2}, kOrigins, std::vector<glm::vec3>(4)); }), HasSubstr("no pixel"));
  EXPECT_THAT(errorOf([] { fromArrays({2, 2}, kOrigins, kDirections, 5, 5); }), HasSubstr("from 5 to 5"));
  EXPECT_THAT(errorOf([] { fromArrays({2, 2}, kOrigins, kDirections, -1, 5); }), HasSubstr("from -1"));
  EXPECT_THAT(errorOf([] { fromArrays({2, 2}, kOrigins, kDirections, 0, kNan); }), HasSubstr("nan"));
}

TEST(RayMap, refusesPolylinesThatAreNoRays) {
  const auto error = [](std::vector<size_t> ends, std::vector<glm::vec3> points, std::vector<float> parameters) {
    return errorOf([&] {
      RayMap::ofPolylines({2, 1}, std::move(ends), std::move(points), std::move(parameters), {}, "lines");
    });
  };
  const std::vector<glm::vec3> two{{0, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(error({0, 2}, two, {0, 1}), "");
  EXPECT_THAT(error({0}, two, {0, 1}), HasSubstr("1 ends"));
  EXPECT_THAT(error({0, 1}, two, {0, 1}), HasSubstr("2 ends, 2 points"));
  EXPECT_THAT(error({1, 2}, two, {0, 1}), HasSubstr("pixel (0, 0)"));
  EXPECT_THAT(error({0, 2}, two, {1, 1}), HasSubstr("does not grow"));
  EXPECT_THAT(error({0, 2}, {{0, 0, 0}, {0, kNan, 1}}, {0, 1}), HasSubstr("pixel (1, 0) has a number"));
  EXPECT_THAT(error({0, 105}, std::vector<glm::vec3>(105), std::vector<float>(105)), HasSubstr("from 2 to 104"));
}

/// Bends that are nearer to each other than parameters are rounded have one parameter.
TEST(RayMap, bendsAtOneParameterAreOne) {
  const RayMap map = RayMap::ofCamera(
      {2, 1},
      [](const glm::vec2& pixel) {
        RayPath path;
        path.add({0, 0, 0}, 1);
        path.add({0, 0, 1}, pixel.x < 1 ? 2 : 1);
        path.add({0, 1, 1}, pixel.x < 1 ? 2 : 1);
        if (pixel.x < 1) {
          path.add({0, 2, 1}, 3);
        }
        return path;
      },
      {}, "test");
  const RayPath path = map.ray(0, 0).path();
  ASSERT_EQ(path.size(), 3u);
  EXPECT_EQ(path[1], glm::vec3(0, 0, 1));
  EXPECT_EQ(path.t(2), 3);
  EXPECT_TRUE(map.ray(1, 0).empty()) << "a point is no ray";
}

TEST(RayMap, ofAViewStandsWhereItIsPlaced) {
  RayMapNotes notes;
  notes.frame = RayFrame::kView;
  const std::vector<glm::vec3> origins{{0, 0, 0}, {0.5f, 0.25f, 0}};
  const std::vector<glm::vec3> directions{{0, 0, -1}, {1, 0, 0}};
  const RayMap lens = RayMap::ofStraightRays({2, 1}, origins, directions, 0, 2, notes, "lens");
  View view;
  view.eye = {3, 0, 0};
  view.target = {0, 0, 0};
  const RayMap placed = lens.placedAt(view);
  EXPECT_EQ(placed.notes().frame, RayFrame::kWorld);
  // The view looks along -x: its right is -z, its up y.
  EXPECT_LT(glm::distance(placed.ray(0, 0).points[1], glm::vec3(1, 0, 0)), 1e-6f);
  EXPECT_LT(glm::distance(placed.ray(1, 0).points[0], glm::vec3(3, 0.25f, -0.5f)), 1e-6f);
  EXPECT_LT(glm::distance(placed.ray(1, 0).points[1], glm::vec3(3, 0.25f, -2.5f)), 1e-6f);
}

TEST(RayMap, factsSayWhereRaysBegin) {
  const RayMapFacts facts = factsOf(pushBroomMap({8, 4}));
  EXPECT_EQ(facts.rays, 32u);
  EXPECT_EQ(facts.bent, 0u);
  EXPECT_EQ(facts.segments, 1u);
  EXPECT_FLOAT_EQ(facts.lower.x, -1.75f);
  EXPECT_FLOAT_EQ(facts.upper.x, 1.75f);
  EXPECT_EQ(facts.tMax, 100);
}

}  // namespace
}  // namespace ocelli::test
