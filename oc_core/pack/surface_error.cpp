#include "oc_core/pack/surface_error.h"

#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

namespace ocelli {
namespace {

/// The point of a triangle that is nearest to p, as weights of its corners (C. Ericson, Real-Time Collision Detection,
/// 5.1.5).
glm::vec3 nearestWeights(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 ab = b - a;
  const glm::vec3 ac = c - a;
  const glm::vec3 ap = p - a;
  const float d1 = glm::dot(ab, ap);
  const float d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) {
    return {1, 0, 0};
  }
  const glm::vec3 bp = p - b;
  const float d3 = glm::dot(ab, bp);
  const float d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) {
    return {0, 1, 0};
  }
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const float v = d1 > d3 ? d1 / (d1 - d3) : 0;
    return {1 - v, v, 0};
  }
  const glm::vec3 cp = p - c;
  const float d5 = glm::dot(ab, cp);
  const float d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) {
    return {0, 0, 1};
  }
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const float w = d2 > d6 ? d2 / (d2 - d6) : 0;
    return {1 - w, 0, w};
  }
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const float sum = (d4 - d3) + (d5 - d6);
    const float w = sum > 0 ? (d4 - d3) / sum : 0;
    return {0, 1 - w, w};
  }
  const float sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

}  // namespace

CoarseSurface::CoarseSurface(const WeldedTriangles& fine, std::span<const uint32_t> coarse,
                             std::span<const float> spread)
    : fine_(fine), spread_(spread), distances2_(coarse.size() / 3) {
  facets_.reserve(coarse.size() / 3);
  for (size_t i = 0; i + 2 < coarse.size(); i += 3) {
    Facet facet{coarse[i], coarse[i + 1], coarse[i + 2], 0};
    const std::array<glm::vec3, 3> p{fine.positions[facet.a], fine.positions[facet.b], fine.positions[facet.c]};
    const float longest = std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
    const float twiceArea = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    facet.height = longest > 0 ? twiceArea / longest : 0;
    facets_.push_back(facet);
    const Sphere sphere = aroundPoints(p);
    bounds_.x.push_back(sphere.center.x);
    bounds_.y.push_back(sphere.center.y);
    bounds_.z.push_back(sphere.center.z);
    bounds_.radius.push_back(sphere.radius);
  }
}

LevelError CoarseSurface::errorAgainst(const Facet& facet, uint32_t vertex) const {
  const auto& positions = fine_.positions;
  const auto& colors = fine_.colors;
  const glm::vec3 p = positions[vertex];
  const glm::vec3 w = nearestWeights(p, positions[facet.a], positions[facet.b], positions[facet.c]);
  const glm::vec3 q = positions[facet.a] * w.x + positions[facet.b] * w.y + positions[facet.c] * w.z;
  const glm::vec3 color =
      linearColor(colors[facet.a]) * w.x + linearColor(colors[facet.b]) * w.y + linearColor(colors[facet.c]) * w.z;
  const glm::vec3 off = glm::abs(color - linearColor(colors[vertex]));
  return {glm::distance(p, q), (std::max({off.r, off.g, off.b}) + spreadOf(vertex)) * facet.height / 3};
}

LevelError CoarseSurface::errorAt(uint32_t vertex) const {
  constexpr float kNothing = std::numeric_limits<float>::infinity();
  if (facets_.empty()) {
    return {kNothing, kNothing};
  }
  const glm::vec3 p = fine_.positions[vertex];
  // Floats that are not negative are in the order of their bits, of which compilers find the least many at a time.
  int32_t least = std::numeric_limits<int32_t>::max();
  for (size_t i = 0; i < facets_.size(); ++i) {
    const float x = bounds_.x[i] - p.x;
    const float y = bounds_.y[i] - p.y;
    const float z = bounds_.z[i] - p.z;
    distances2_[i] = x * x + y * y + z * z;
    least = std::min(least, std::bit_cast<int32_t>(distances2_[i]));
  }
  // One that is near leaves few others to look at.
  const auto first = std::ranges::find(distances2_, std::bit_cast<float>(least)) - distances2_.begin();
  LevelError best = errorAgainst(facets_[static_cast<size_t>(first)], vertex);
  constexpr size_t kAtOnce = 32;
  for (size_t begin = 0; begin < facets_.size(); begin += kAtOnce) {
    const size_t end = std::min(begin + kAtOnce, facets_.size());
    const float reach = best.larger();
    int within = 0;
    for (size_t i = begin; i < end; ++i) {
      const float r = reach + bounds_.radius[i];
      within += distances2_[i] <= r * r ? 1 : 0;
    }
    for (size_t i = begin; within > 0 && i < end; ++i) {
      const float r = reach + bounds_.radius[i];
      if (distances2_[i] > r * r) {
        continue;
      }
      const LevelError error = errorAgainst(facets_[i], vertex);
      if (std::tuple(error.larger(), error.distance, error.color) <
          std::tuple(best.larger(), best.distance, best.color)) {
        best = error;
      }
    }
  }
  return best;
}

LevelError CoarseSurface::spreadError() const {
  float error = 0;
  if (!spread_.empty()) {
    for (const Facet& facet : facets_) {
      error = std::max(error, std::max({spread_[facet.a], spread_[facet.b], spread_[facet.c]}) * facet.height / 3);
    }
  }
  return {0, error};
}

}  // namespace ocelli
