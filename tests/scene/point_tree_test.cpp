#include "oc_core/scene/point_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "oc_core/base/parallel.h"
#include "oc_core/base/random.h"

namespace ocelli {
namespace {

std::vector<uint32_t> nearestByHand(const std::vector<glm::vec3>& points, uint32_t point, size_t count) {
  std::vector<std::tuple<float, uint32_t>> others;
  for (uint32_t i = 0; i < points.size(); ++i) {
    const glm::vec3 away = points[i] - points[point];
    if (i != point) {
      others.emplace_back(away.x * away.x + away.y * away.y + away.z * away.z, i);
    }
  }
  std::sort(others.begin(), others.end());
  std::vector<uint32_t> nearest;
  for (size_t i = 0; i < std::min(count, others.size()); ++i) {
    nearest.push_back(std::get<1>(others[i]));
  }
  return nearest;
}

void expectNearestOfAll(const std::vector<glm::vec3>& points, size_t count) {
  const PointTree tree(points);
  std::array<PointNeighbor, PointTree::kMaxNeighbors> room;
  std::vector<bool> met(points.size(), false);
  for (size_t place = 0; place < points.size(); ++place) {
    const uint32_t point = tree.pointAt(place);
    ASSERT_FALSE(met[point]);
    met[point] = true;
    std::vector<uint32_t> found;
    for (const PointNeighbor& neighbor : tree.nearest(point, points[point], count, room)) {
      found.push_back(neighbor.point);
    }
    ASSERT_EQ(found, nearestByHand(points, point, count)) << point;
  }
}

TEST(PointTree, FindsWhatComparingAllFinds) {
  Random random(3);
  for (const size_t size : {1u, 2u, 8u, 9u, 17u, 100u, 500u}) {
    std::vector<glm::vec3> points;
    for (size_t i = 0; i < size; ++i) {
      points.push_back({random.inRange(-1, 1), random.inRange(-1, 1), random.inRange(-0.01f, 0.01f)});
    }
    expectNearestOfAll(points, 1);
    expectNearestOfAll(points, 10);
    expectNearestOfAll(points, PointTree::kMaxNeighbors);
  }
}

TEST(PointTree, TakesTheLowerNumbersOfEquallyNearPoints) {
  std::vector<glm::vec3> grid;
  for (int i = 0; i < 12 * 12 * 5; ++i) {
    grid.push_back({static_cast<float>(i % 12), static_cast<float>(i / 12 % 12), static_cast<float>(i / 144)});
  }
  expectNearestOfAll(grid, 10);
  expectNearestOfAll(std::vector<glm::vec3>(300, glm::vec3(0.5f)), 7);
}

TEST(PointTree, IsTheSameWithAnyNumberOfThreads) {
  Random random(8);
  std::vector<glm::vec3> points(70'000);
  for (glm::vec3& point : points) {
    point = {random.inRange(0, 1), random.inRange(0, 1), random.inRange(0, 1)};
  }
  setThreadCount(1);
  const PointTree one(points);
  setThreadCount(4);
  const PointTree four(points);
  setThreadCount(0);
  for (size_t place = 0; place < points.size(); ++place) {
    ASSERT_EQ(one.pointAt(place), four.pointAt(place));
  }
}

}  // namespace
}  // namespace ocelli
