#include "oc_core/scene/point_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <utility>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// The least variance, over the middle one, up to which neighbours are a surface: 0.25 where two planes meet at a
/// right angle at the point, about 0.5 where neighbours fill space.
constexpr double kMaxOffPlane = 0.3;
/// The middle variance, over the largest one, down to which neighbours are more than a line.
constexpr double kMinAcross = 0.01;

/// Turns `a`, symmetric, so that a[p][q] is 0, and the columns of `vectors` with it (Jacobi 1846).
void annihilate(glm::dmat3& a, glm::dmat3& vectors, int p, int q) {
  if (std::abs(a[q][p]) <= 1e-16 * (a[p][p] + a[q][q])) {
    return;
  }
  const double theta = (a[q][q] - a[p][p]) / (2 * a[q][p]);
  const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1);
  const double s = t * c;
  glm::dmat3 turn(1);
  turn[p][p] = c;
  turn[q][q] = c;
  turn[q][p] = s;
  turn[p][q] = -s;
  a = glm::transpose(turn) * a * turn;
  a[p][q] = a[q][p] = 0;
  vectors = vectors * turn;
}

/// Two unit vectors that make a right-handed frame with `normal`.
std::pair<glm::vec3, glm::vec3> planeAxes(const glm::vec3& normal) {
  const glm::vec3 beside = std::abs(normal.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 x = glm::normalize(glm::cross(beside, normal));
  return {x, glm::cross(normal, x)};
}

/// The same along the axes of the spread that `offsets` have in the plane.
std::pair<glm::vec3, glm::vec3> spreadAxes(std::span<const glm::vec3> offsets, const glm::vec3& normal) {
  const auto [x, y] = planeAxes(normal);
  float xx = 0;
  float xy = 0;
  float yy = 0;
  for (const glm::vec3& offset : offsets) {
    const glm::vec2 flat(glm::dot(offset, x), glm::dot(offset, y));
    xx += flat.x * flat.x;
    xy += flat.x * flat.y;
    yy += flat.y * flat.y;
  }
  const float angle = 0.5f * std::atan2(2 * xy, xx - yy);
  const glm::vec3 along = std::cos(angle) * x + std::sin(angle) * y;
  return {along, glm::cross(normal, along)};
}

/// A convex polygon around the origin. Each cut adds one corner at the most, but for rounding: corners that it makes
/// out of edges shorter than it, and for which there is no room, are left out.
struct Cell {
  std::array<glm::vec2, 4 + kMaxPanelNeighbors> corners;
  size_t size = 0;

  void push(const glm::vec2& corner) {
    if (size < corners.size()) {
      corners[size++] = corner;
    }
  }
};

/// What of `cell` is nearer to the origin than to `other`.
Cell nearerPart(const Cell& cell, const glm::vec2& other) {
  const float limit = glm::dot(other, other) / 2;
  Cell kept;
  for (size_t i = 0; i < cell.size; ++i) {
    const glm::vec2& a = cell.corners[i];
    const glm::vec2& b = cell.corners[i + 1 < cell.size ? i + 1 : 0];
    const float beyondA = glm::dot(a, other) - limit;
    const float beyondB = glm::dot(b, other) - limit;
    if (beyondA <= 0) {
      kept.push(a);
    }
    if ((beyondA < 0 && beyondB > 0) || (beyondA > 0 && beyondB < 0)) {
      kept.push(glm::mix(a, b, beyondA / (beyondA - beyondB)));
    }
  }
  return kept;
}

}  // namespace

PointPlane fittingPlane(std::span<const glm::vec3> offsets) {
  const double count = static_cast<double>(offsets.size()) + 1;  // with the point itself
  glm::dvec3 middle(0);
  for (const glm::vec3& offset : offsets) {
    middle += glm::dvec3(offset);
  }
  middle /= count;
  glm::dmat3 spread = glm::outerProduct(middle, middle);
  for (const glm::vec3& offset : offsets) {
    const glm::dvec3 away = glm::dvec3(offset) - middle;
    spread += glm::outerProduct(away, away);
  }
  glm::dmat3 vectors(1);
  constexpr int kSweeps = 8;  // errors shrink cubically or faster
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    annihilate(spread, vectors, 0, 1);
    annihilate(spread, vectors, 0, 2);
    annihilate(spread, vectors, 1, 2);
  }
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, {}, [&](int i) { return spread[i][i]; });
  const double least = spread[order[0]][order[0]];
  const double between = spread[order[1]][order[1]];
  const double most = spread[order[2]][order[2]];
  return {glm::normalize(glm::vec3(vectors[order[0]])), between > kMinAcross * most && least <= kMaxOffPlane * between};
}

PointPanel cellPanel(std::span<const glm::vec3> offsets, const glm::vec3& normal, float reach) {
  OC_CHECK(offsets.size() <= kMaxPanelNeighbors, "a cell has room for its corners");
  const auto [x, y] = spreadAxes(offsets, normal);
  Cell cell;
  for (const glm::vec2& corner :
       {glm::vec2(-reach, -reach), glm::vec2(reach, -reach), glm::vec2(reach, reach), glm::vec2(-reach, reach)}) {
    cell.push(corner);
  }
  for (const glm::vec3& offset : offsets) {
    const glm::vec2 flat(glm::dot(offset, x), glm::dot(offset, y));
    const float off = glm::dot(offset, normal);
    if (off * off < glm::dot(flat, flat)) {
      cell = nearerPart(cell, flat);
    }
  }
  glm::vec2 lower(0);
  glm::vec2 upper(0);
  for (size_t i = 0; i < cell.size; ++i) {
    lower = glm::min(lower, cell.corners[i]);
    upper = glm::max(upper, cell.corners[i]);
  }
  const glm::vec2 center = (lower + upper) * 0.5f;
  const glm::vec2 half = (upper - lower) * 0.5f;
  return {center.x * x + center.y * y, half.x * x, half.y * y};
}

PointPanel squarePanel(std::span<const glm::vec3> offsets, const glm::vec3& normal, float half) {
  const auto [x, y] = spreadAxes(offsets, normal);
  return {glm::vec3(0), half * x, half * y};
}

}  // namespace ocelli
