#include "oc_core/pack/rim_error.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/disjoint_sets.h"
#include "oc_core/pack/sphere.h"

namespace ocelli {
namespace {

float squaredDistanceToSegment(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 ab = b - a;
  const float length2 = glm::dot(ab, ab);
  const float along = length2 > 0 ? glm::clamp(glm::dot(p - a, ab) / length2, 0.0f, 1.0f) : 0;
  const glm::vec3 off = a + ab * along - p;
  return glm::dot(off, off);
}

}  // namespace

RimErrors::RimErrors(std::span<const glm::vec3> positions, std::span<const OpenEdge> fine,
                     std::span<const OpenEdge> coarse)
    : positions_(positions), rimOf_(fine.empty() ? 0 : positions.size(), kNone) {
  if (fine.empty()) {
    return;
  }
  DisjointSets sets(positions.size());
  for (const OpenEdge& edge : fine) {
    sets.join(edge.from, edge.to);
  }
  std::vector<std::vector<glm::vec3>> points;
  for (const OpenEdge& edge : fine) {
    for (const uint32_t place : {edge.from, edge.to}) {
      uint32_t& rim = rimOf_[sets.least(place)];
      if (rim == kNone) {
        rim = static_cast<uint32_t>(points.size());
        points.emplace_back();
      }
      points[rim].push_back(positions[place]);
      rimOf_[place] = rim;
    }
  }
  for (const std::vector<glm::vec3>& each : points) {
    rims_.push_back({{}, aroundPoints(each).radius});
  }
  for (const OpenEdge& edge : coarse) {
    if (rimOf_[edge.from] != kNone && rimOf_[edge.from] == rimOf_[edge.to]) {
      rims_[rimOf_[edge.from]].coarse.push_back(edge);
    }
  }
}

float RimErrors::errorAt(uint32_t place) const {
  if (rimOf_.empty() || rimOf_[place] == kNone) {
    return 0;
  }
  const Rim& rim = rims_[rimOf_[place]];
  if (rim.coarse.empty()) {
    return rim.radius;
  }
  float nearest2 = std::numeric_limits<float>::infinity();
  for (const OpenEdge& edge : rim.coarse) {
    nearest2 =
        std::min(nearest2, squaredDistanceToSegment(positions_[place], positions_[edge.from], positions_[edge.to]));
  }
  return std::sqrt(nearest2);
}

}  // namespace ocelli
