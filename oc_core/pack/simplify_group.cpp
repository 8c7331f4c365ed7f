#include "oc_core/pack/simplify_group.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "oc_core/pack/one_color.h"

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

/// A triangle with what tells that it is too far away to be the nearest.
struct Facet {
  std::array<uint32_t, 3> corners;
  Sphere bounds;
  float height = 0;  ///< over its longest side
};

std::vector<Facet> facetsOf(const std::vector<uint32_t>& indices, const std::vector<glm::vec3>& positions) {
  std::vector<Facet> facets;
  facets.reserve(indices.size() / 3);
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    Facet facet{{indices[i], indices[i + 1], indices[i + 2]}, {}, 0};
    const std::array<glm::vec3, 3> p{positions[indices[i]], positions[indices[i + 1]], positions[indices[i + 2]]};
    facet.bounds = aroundPoints(p);
    const float longest = std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
    const float twiceArea = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    facet.height = longest > 0 ? twiceArea / longest : 0;
    facets.push_back(facet);
  }
  return facets;
}

/// How far the surface made of `facets` is from a vertex of the finer one, whose own colour is off by `spread`.
LevelError errorAt(uint32_t vertex, const WeldedTriangles& fine, const std::vector<Facet>& facets, float spread) {
  const glm::vec3 p = fine.positions[vertex];
  float nearest = std::numeric_limits<float>::infinity();
  const Facet* found = nullptr;
  glm::vec3 weights(0);
  for (const Facet& facet : facets) {
    const float reach = nearest + facet.bounds.radius;
    const glm::vec3 step = facet.bounds.center - p;
    if (glm::dot(step, step) > reach * reach) {
      continue;
    }
    const auto& [a, b, c] = facet.corners;
    const glm::vec3 w = nearestWeights(p, fine.positions[a], fine.positions[b], fine.positions[c]);
    const glm::vec3 q = fine.positions[a] * w.x + fine.positions[b] * w.y + fine.positions[c] * w.z;
    const float distance = glm::distance(p, q);
    if (distance < nearest) {
      nearest = distance;
      found = &facet;
      weights = w;
    }
  }
  if (found == nullptr) {
    return {std::numeric_limits<float>::infinity(), 0};
  }
  const glm::vec3 color = linearColor(fine.colors[found->corners[0]]) * weights.x +
                          linearColor(fine.colors[found->corners[1]]) * weights.y +
                          linearColor(fine.colors[found->corners[2]]) * weights.z;
  const glm::vec3 off = glm::abs(color - linearColor(fine.colors[vertex]));
  return {nearest, (std::max({off.r, off.g, off.b}) + spread) * found->height / 3};
}

/// The triangles that meshoptimizer makes of `part`, with its open edges as they are, so that the whole has `target`
/// indices or more.
std::vector<uint32_t> fewerTriangles(const std::vector<uint32_t>& part, const WeldedTriangles& welded, size_t target) {
  std::vector<uint32_t> fewer(part.size());
  constexpr float kAnyError = 1;  // of the extent: as much as the target asks for
  fewer.resize(meshopt_simplify(fewer.data(), part.data(), part.size(), &welded.positions[0].x, welded.positions.size(),
                                sizeof(glm::vec3), target, kAnyError, meshopt_SimplifyLockBorder, nullptr));
  return fewer;
}

/// What some coarser triangles are off by, at the vertices that they left out.
struct LeftOut {
  uint32_t vertex = 0;
  LevelError error;
};

std::vector<LeftOut> errorsOf(const std::vector<uint32_t>& coarse, const WeldedTriangles& welded,
                              std::span<const float> spread) {
  std::vector<uint8_t> isLeft(welded.positions.size(), 0);
  for (const uint32_t vertex : coarse) {
    isLeft[vertex] = 1;
  }
  const std::vector<Facet> facets = facetsOf(coarse, welded.positions);
  std::vector<LeftOut> errors;
  for (uint32_t vertex = 0; vertex < welded.positions.size(); ++vertex) {
    if (isLeft[vertex] == 0) {
      errors.push_back({vertex, errorAt(vertex, welded, facets, spread.empty() ? 0 : spread[vertex])});
    }
  }
  return errors;
}

/// The vertices that are off by far more than most: one of them would count for all of the group.
std::vector<uint32_t> farOff(const std::vector<LeftOut>& errors) {
  std::vector<float> sorted;
  for (const LeftOut& each : errors) {
    sorted.push_back(each.error.larger());
  }
  const size_t most = sorted.size() * 3 / 4;
  std::vector<uint32_t> vertices;
  if (most < sorted.size()) {
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(most), sorted.end());
    constexpr float kFarMore = 5;
    for (const LeftOut& each : errors) {
      if (each.error.larger() > kFarMore * sorted[most]) {
        vertices.push_back(each.vertex);
      }
    }
  }
  return vertices;
}

/// What the vertices that are left are off by, as they stand for several colours.
float spreadError(const std::vector<uint32_t>& coarse, const WeldedTriangles& welded, std::span<const float> spread) {
  float error = 0;
  if (!spread.empty()) {
    for (const Facet& facet : facetsOf(coarse, welded.positions)) {
      for (const uint32_t corner : facet.corners) {
        error = std::max(error, spread[corner] * facet.height / 3);
      }
    }
  }
  return error;
}

/// `spread`: by how much the colour of each vertex is off; empty where none is.
std::optional<SimplifiedTriangles> simplifiedAsTheyAre(const WeldedTriangles& welded, std::span<const float> spread) {
  const std::vector<uint32_t>& fine = welded.indices;
  const size_t target = welded.triangleCount() / 2 * 3;
  std::vector<uint8_t> stays(welded.positions.size(), 0);
  std::vector<uint32_t> coarse = fewerTriangles(fine, welded, target);
  std::vector<LeftOut> errors = errorsOf(coarse, welded, spread);
  constexpr int kMaxRounds = 6;
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::vector<uint32_t> off = farOff(errors);
    if (off.empty()) {
      break;
    }
    // The triangles around them stay as they are.
    for (const uint32_t vertex : off) {
      stays[vertex] = 1;
    }
    std::vector<uint32_t> staying;
    std::vector<uint32_t> rest;
    for (size_t i = 0; i < fine.size(); i += 3) {
      const bool stay = stays[fine[i]] != 0 || stays[fine[i + 1]] != 0 || stays[fine[i + 2]] != 0;
      (stay ? staying : rest).insert((stay ? staying : rest).end(), {fine[i], fine[i + 1], fine[i + 2]});
    }
    if (rest.empty()) {
      return std::nullopt;
    }
    coarse = fewerTriangles(rest, welded, target > staying.size() ? target - staying.size() : 0);
    coarse.insert(coarse.end(), staying.begin(), staying.end());
    errors = errorsOf(coarse, welded, spread);
  }
  if (coarse.empty() || static_cast<float>(coarse.size()) > kWorthwhile * static_cast<float>(fine.size())) {
    return std::nullopt;
  }
  SimplifiedTriangles result;
  result.error.color = spreadError(coarse, welded, spread);
  for (const LeftOut& each : errors) {
    result.error = {std::max(result.error.distance, each.error.distance),
                    std::max(result.error.color, each.error.color)};
  }
  Welder welder(coarse.size() / 3);
  for (size_t i = 0; i < coarse.size(); i += 3) {
    std::array<uint32_t, 3> corners{};
    for (size_t k = 0; k < 3; ++k) {
      corners[k] = welder.vertex(welded.positions[coarse[i + k]], welded.colors[coarse[i + k]]);
    }
    welder.add(corners[0], corners[1], corners[2]);
  }
  result.triangles = welder.take();
  return result;
}

}  // namespace

std::optional<SimplifiedTriangles> simplified(const WeldedTriangles& welded) {
  if (std::optional<SimplifiedTriangles> coarse = simplifiedAsTheyAre(welded, {})) {
    return coarse;
  }
  const OneColorTriangles oneColor = withOneColor(welded);
  return oneColor.triangles.positions.size() < welded.positions.size()
             ? simplifiedAsTheyAre(oneColor.triangles, oneColor.spread)
             : std::nullopt;
}

}  // namespace ocelli
