#include "oc_core/constructor/walk_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
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

/// Of all reached cells: the most steps to one, and of all together.
std::pair<size_t, size_t> stepsFrom(const std::vector<WalkRegion>& regions, uint32_t cell) {
  const WalkTour tour = walkTourOf(regions, cell, TourOrder::kBreadthFirst);
  std::pair<size_t, size_t> steps{0, 0};
  for (const uint32_t reached : tour.order) {
    steps.first = std::max(steps.first, tour.stops[reached].steps);
    steps.second += tour.stops[reached].steps;
  }
  return steps;
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
  WalkStart best;
  auto least = std::pair(std::numeric_limits<size_t>::max(), 0.0);
  for (const glm::dvec3& heading : {axis, -axis, right, -right}) {
    const auto [from, to] = extentAlong(regions[cell].border, planOf(heading));
    const auto cost = std::pair(exitsBeside(regions[cell], planOf(heading)), from - to);
    if (cost < least) {
      least = cost;
      best = {cell, heading};
    }
  }
  return best;
}

WalkStart chooseWalkStart(const WalkMap& map, const std::vector<WalkRegion>& regions) {
  std::map<uint32_t, double> floors;
  const auto partOf = [&](const WalkRegion& region) {
    return region.cell < map.partOfCell.size() ? map.partOfCell[region.cell] : 0u;
  };
  for (const WalkRegion& region : regions) {
    floors[partOf(region)] += planArea(region.border);
  }
  const uint32_t largest = std::max_element(floors.begin(), floors.end(), [](const auto& a, const auto& b) {
                             return a.second < b.second;
                           })->first;
  WalkStart best;
  auto least = std::tuple(true, std::numeric_limits<size_t>::max(), std::numeric_limits<size_t>::max());
  for (const WalkRegion& region : regions) {
    if (partOf(region) != largest || region.border.empty()) {
      continue;
    }
    const WalkStart side = chooseWalkSide(map, regions, region.cell);
    const auto [most, sum] = stepsFrom(regions, region.cell);
    const auto cost = std::tuple(exitsBeside(region, planOf(side.heading)) > 0, most, sum);
    if (cost < least) {
      least = cost;
      best = side;
    }
  }
  return best;
}

}  // namespace ocelli
