#include "oc_core/sea/sea_graph.h"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <numeric>
#include <utility>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// Boost.Polygon takes whole numbers of 32 bits, and is exact for them.
constexpr double kGrid = 1 << 28;

using GridPoint = boost::polygon::point_data<int32_t>;

std::vector<GridPoint> onGrid(std::span<const glm::dvec2> positions) {
  glm::dvec2 lower = positions[0];
  glm::dvec2 upper = positions[0];
  for (const glm::dvec2& position : positions) {
    lower = glm::min(lower, position);
    upper = glm::max(upper, position);
  }
  const double extent = std::max({upper.x - lower.x, upper.y - lower.y, 1e-300});
  std::vector<GridPoint> points;
  points.reserve(positions.size());
  for (const glm::dvec2& position : positions) {
    const glm::dvec2 place = (position - lower) / extent * kGrid;
    points.emplace_back(static_cast<int32_t>(std::lround(place.x)), static_cast<int32_t>(std::lround(place.y)));
  }
  return points;
}

}  // namespace

std::vector<glm::dvec2> planePositions(std::span<const glm::dvec3> positions) {
  OC_CHECK(!positions.empty(), "a sea has images");
  glm::dvec3 lower = positions[0];
  glm::dvec3 upper = positions[0];
  for (const glm::dvec3& position : positions) {
    lower = glm::min(lower, position);
    upper = glm::max(upper, position);
  }
  const glm::dvec3 extent = upper - lower;
  // Of equal extents the height is left out.
  std::array<int, 3> axes{0, 2, 1};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return extent[a] > extent[b]; });
  const auto [first, second] = std::minmax(axes[0], axes[1]);
  std::vector<glm::dvec2> plane;
  plane.reserve(positions.size());
  for (const glm::dvec3& position : positions) {
    plane.emplace_back(position[first], position[second]);
  }
  return plane;
}

std::vector<std::array<uint32_t, 2>> delaunayEdges(std::span<const glm::dvec2> positions) {
  OC_CHECK(!positions.empty(), "a sea has images");
  const std::vector<GridPoint> points = onGrid(positions);
  std::vector<std::array<uint32_t, 2>> edges;
  const auto add = [&](uint32_t a, uint32_t b) { edges.push_back({std::min(a, b), std::max(a, b)}); };
  // One of each place; the others hang on it.
  std::vector<GridPoint> places;
  std::vector<uint32_t> positionOfPlace;
  std::map<std::pair<int32_t, int32_t>, uint32_t> lastAt;
  for (uint32_t i = 0; i < points.size(); ++i) {
    const auto [found, isNew] = lastAt.try_emplace({points[i].x(), points[i].y()}, i);
    if (isNew) {
      places.push_back(points[i]);
      positionOfPlace.push_back(i);
    } else {
      add(found->second, i);
      found->second = i;
    }
  }
  boost::polygon::voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(places.begin(), places.end(), &diagram);
  for (const auto& edge : diagram.edges()) {
    if (edge.is_primary()) {
      const size_t a = edge.cell()->source_index();
      const size_t b = edge.twin()->cell()->source_index();
      if (a < b) {
        add(positionOfPlace[a], positionOfPlace[b]);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace ocelli
