#include "oc_core/worlds/place_walk.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

void addLanes(std::vector<glm::dvec3>& corners, const LaneArea& area, double spacing, double height) {
  const glm::dvec2 start(area.start);
  const glm::dvec2 way = glm::dvec2(area.opposite) - start;
  const double across = area.isAlongX ? way.y : way.x;
  const auto lanes = static_cast<int>(std::floor(std::abs(across) / spacing + 1e-6)) + 1;
  for (int lane = 0; lane < lanes; ++lane) {
    const double aside = std::copysign(spacing * lane, across);
    for (const int end : {lane % 2, 1 - lane % 2}) {
      const glm::dvec2 p = start + (area.isAlongX ? glm::dvec2(end * way.x, aside) : glm::dvec2(aside, end * way.y));
      corners.emplace_back(p.x, height, p.y);
    }
  }
}

}  // namespace

std::vector<glm::vec3> laneWalk(const std::vector<LaneArea>& areas, const SeaWalk& sea, float eyeHeight) {
  std::vector<glm::dvec3> corners;
  for (const LaneArea& area : areas) {
    addLanes(corners, area, sea.spacing, eyeHeight);
  }
  double left = static_cast<double>(sea.spacing) * static_cast<double>(sea.count - 1);
  std::vector<glm::vec3> path{glm::vec3(corners.front())};
  for (size_t i = 0; i + 1 < corners.size() && left > 0; ++i) {
    const double part = glm::distance(corners[i], corners[i + 1]);
    if (part > 0) {
      path.emplace_back(glm::mix(corners[i], corners[i + 1], std::min(1.0, left / part)));
    }
    left -= part;
  }
  OC_CHECK(left <= 1e-6, "the areas hold the walk");
  return path;
}

}  // namespace ocelli
