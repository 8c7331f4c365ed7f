#include "oc_core/scene/scene_guides.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"

namespace ocelli {

SceneGuides moved(const SceneGuides& guides, const glm::mat4& newFromOld) {
  const auto point = [&](const glm::vec3& p) { return glm::vec3(newFromOld * glm::vec4(p, 1)); };
  SceneGuides result;
  for (const Portal& portal : guides.portals) {
    result.portals.push_back(moved(portal, newFromOld));
  }
  for (const glm::vec3& p : guides.path) {
    result.path.push_back(point(p));
  }
  if (guides.target) {
    result.target = {guides.target->object, {point(guides.target->box.lower), point(guides.target->box.upper)}};
  }
  if (guides.maze) {
    result.maze = moved(*guides.maze, newFromOld);
  }
  if (guides.sea) {
    result.sea = {guides.sea->count, guides.sea->spacing * glm::length(glm::vec3(newFromOld[0]))};
  }
  if (guides.walk) {
    result.walk = moved(*guides.walk, newFromOld);
  }
  return result;
}

std::vector<glm::vec3> seaPositions(const std::vector<glm::vec3>& path, const SeaWalk& sea) {
  std::vector<glm::vec3> positions;
  positions.reserve(sea.count);
  double before = 0;  // along the path, of the beginning of segment i
  size_t i = 0;
  for (size_t k = 0; k < sea.count && !path.empty(); ++k) {
    const double wanted = static_cast<double>(sea.spacing) * static_cast<double>(k);
    const auto lengthOf = [&](size_t s) { return glm::distance(glm::dvec3(path[s]), glm::dvec3(path[s + 1])); };
    while (i + 1 < path.size() && before + lengthOf(i) < wanted) {
      before += lengthOf(i++);
    }
    if (i + 1 >= path.size()) {
      if (wanted - before > sea.spacing) {
        break;
      }
      positions.push_back(path.back());
      continue;
    }
    const double length = lengthOf(i);
    const double t = length > 0 ? std::min(1.0, (wanted - before) / length) : 0;
    positions.emplace_back(glm::mix(glm::dvec3(path[i]), glm::dvec3(path[i + 1]), t));
  }
  if (positions.size() < sea.count) {
    throw InputError(
        fmt::format("this path holds {} of {} positions that are {:g} apart", positions.size(), sea.count, sea.spacing),
        "the path of a sea of images", "give a longer path, fewer positions, or a smaller spacing");
  }
  return positions;
}

}  // namespace ocelli
