#include "oc_core/constructor/walk_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "oc_core/base/conventions.h"
#include "oc_core/constructor/walk_tour.h"

namespace ocelli {
namespace {

/// How far away the viewpoint of almost parallel rays lies, in widths of the entry.
constexpr double kFarBehind = 50;
/// How far within the cell rays begin, in its lengths: beside walls and the planes where they turn.
constexpr double kWithin = 0.02;
/// Openings this near to the side that rays come in by, in depths of the cell, lie beside them.
constexpr double kBeside = 0.05;
/// Cells from which all that can be reached is looked up.
constexpr size_t kMaxTried = 500;
/// Rays begin in cells at least so wide, in heights of openings, if there are any: the image is wider than tall.
constexpr double kWideStart = 1.2;

/// Least and largest distance along a direction.
std::pair<double, double> extentAlong(const PlanPolygon& border, const glm::dvec2& direction) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const glm::dvec2& corner : border) {
    least = std::min(least, glm::dot(corner, direction));
    most = std::max(most, glm::dot(corner, direction));
  }
  return {least, most};
}

size_t exitsBeside(const WalkRegion& region, const glm::dvec2& heading) {
  const auto [least, most] = extentAlong(region.border, heading);
  return static_cast<size_t>(std::count_if(region.exits.begin(), region.exits.end(), [&](const WalkExit& exit) {
    return glm::dot(exit.mouth.middle(), heading) < least + kBeside * (most - least);
  }));
}

/// Of openings.
double medianHeight(const std::vector<WalkRegion>& regions) {
  std::vector<double> heights;
  for (const WalkRegion& region : regions) {
    for (const WalkExit& exit : region.exits) {
      heights.push_back(exit.mouth.height());
    }
  }
  if (heights.empty()) {
    return 0;
  }
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return *middle;
}

/// Whether rays that come in along a direction have room beside each other.
bool isWide(const WalkRegion& region, const glm::dvec2& heading, double tall) {
  const auto [least, most] = extentAlong(region.border, {-heading.y, heading.x});
  return most - least >= kWideStart * tall;
}

struct Reach {
  double floor = 0;  ///< of all cells that are reached
  size_t most = 0;   ///< steps to one of them
  size_t sum = 0;    ///< of steps to all
};

Reach reachFrom(const std::vector<WalkRegion>& regions, uint32_t cell) {
  const WalkTour tour = walkTourOf(regions, cell, TourOrder::kBreadthFirst);
  Reach reach;
  for (const uint32_t reached : tour.order) {
    reach.floor += planArea(regions[reached].border);
    reach.most = std::max(reach.most, tour.stops[reached].steps);
    reach.sum += tour.stops[reached].steps;
  }
  return reach;
}

}  // namespace

WalkBeginning beginWalk(const WalkRegion& region, const WalkStart& start, double tall, double reach, int width,
                        int height) {
  const glm::dvec2 heading = glm::normalize(planOf(start.heading));
  const glm::dvec2 right(-heading.y, heading.x);
  const auto [least, most] = extentAlong(region.border, heading);
  const glm::dvec2 on = heading * (least + kWithin * (most - least)) + right * glm::dot(region.floorPoint, right);
  const auto span = planSpan(region.border, on, on + right, 0).value_or(std::pair(0.0, 0.0));
  const double across = span.second - span.first;
  const double aspect = static_cast<double>(width) / height;
  const double wide = std::min((1 - 2 * kWithin) * across, region.height * tall * aspect);
  const glm::dvec2 middle = on + right * ((span.first + span.second) / 2);
  WalkMouth entry;
  entry.left = middle - right * (wide / 2);
  entry.right = middle + right * (wide / 2);
  entry.floor = std::max(region.floorAt(entry.left), region.floorAt(entry.right));
  entry.top = entry.floor + std::min(region.height * tall, wide / aspect);
  const double distance = kFarBehind * wide;
  View view;
  view.eye = glm::vec3(spaceOf(middle - heading * distance, entry.top));
  view.target = glm::vec3(spaceOf(middle, entry.top));
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(wide / aspect / 2 / distance));
  view.centerShift = {0, -0.5f};
  view.zNear = static_cast<float>(distance - kWithin / 2 * std::min(most - least, wide));
  view.zFar = static_cast<float>(2 * distance + 3 * reach);
  return {GraphCamera(PinholeCamera(view, width, height)), entry,
          planRightOf(region.border, entry.left + right, entry.left)};
}

WalkStart chooseWalkSide(const WalkMap& map, const std::vector<WalkRegion>& regions, uint32_t cell) {
  const glm::dvec3 axis(map.cells[cell].axis);
  const glm::dvec3 right(map.cells[cell].right());
  WalkStart best{cell, axis};
  auto least = std::tuple(true, std::numeric_limits<size_t>::max(), 0.0);
  const double tall = medianHeight(regions);
  for (const glm::dvec3& heading : {axis, -axis, right, -right}) {
    const auto [from, to] = extentAlong(regions[cell].border, planOf(heading));
    const auto cost = std::tuple(!isWide(regions[cell], planOf(heading), tall),
                                 exitsBeside(regions[cell], planOf(heading)), from - to);
    if (cost < least) {
      least = cost;
      best = {cell, heading};
    }
  }
  return best;
}

std::vector<WalkStart> chooseWalkStarts(const WalkMap& map, const std::vector<WalkRegion>& regions, size_t most) {
  // Of large maps the largest cells: how far each reaches takes as long as the map has regions.
  std::vector<uint32_t> tried(map.cells.size());
  std::iota(tried.begin(), tried.end(), 0u);
  if (tried.size() > kMaxTried) {
    std::vector<double> areas;
    for (const uint32_t cell : tried) {
      areas.push_back(planArea(regions[cell].border));
    }
    std::stable_sort(tried.begin(), tried.end(), [&](uint32_t a, uint32_t b) { return areas[a] > areas[b]; });
    tried.resize(kMaxTried);
    std::sort(tried.begin(), tried.end());
  }
  std::vector<Reach> reaches(map.cells.size());
  double largest = 0;
  for (const uint32_t cell : tried) {
    if (!regions[cell].border.empty()) {
      reaches[cell] = reachFrom(regions, cell);
      largest = std::max(largest, reaches[cell].floor);
    }
  }
  using Cost = std::tuple<bool, size_t, size_t>;
  std::vector<std::pair<Cost, WalkStart>> starts;
  const double tall = medianHeight(regions);
  for (const uint32_t cell : tried) {
    const Reach& reach = reaches[cell];
    if (regions[cell].border.empty() || reach.floor < (1 - 1e-9) * largest) {
      continue;
    }
    const WalkStart side = chooseWalkSide(map, regions, cell);
    starts.emplace_back(Cost{!isWide(regions[cell], planOf(side.heading), tall), reach.most, reach.sum}, side);
  }
  std::stable_sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<WalkStart> best;
  for (size_t i = 0; i < std::min(most, starts.size()); ++i) {
    if (std::get<0>(starts[i].first) == std::get<0>(starts[0].first)) {
      best.push_back(starts[i].second);
    }
  }
  return best;
}

}  // namespace ocelli
