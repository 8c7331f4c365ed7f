#include "oc_core/camera/ray_map_quad.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <iterator>

namespace ocelli {
namespace {

/// How much of each neighbour: upper left, upper right, lower left, lower right.
std::array<double, 4> weightsAt(const glm::dvec2& ab) {
  return {(1 - ab.x) * (1 - ab.y), ab.x * (1 - ab.y), (1 - ab.x) * ab.y, ab.x * ab.y};
}

/// The point of a ray at a parameter, and what it moves by for 1 of it; the first and the last segment go on.
struct PointAndSlope {
  glm::dvec3 point;
  glm::dvec3 slope;
};
PointAndSlope pointAndSlope(const RayMapRay& ray, double t) {
  const auto inner = ray.parameters.subspan(1, ray.parameters.size() - 2);
  const auto segment = static_cast<size_t>(
      std::upper_bound(inner.begin(), inner.end(), t, [](double value, float knot) { return value < knot; }) -
      inner.begin());
  const glm::dvec3 from(ray.points[segment]);
  const auto t0 = static_cast<double>(ray.parameters[segment]);
  const glm::dvec3 slope = (glm::dvec3(ray.points[segment + 1]) - from) / (ray.parameters[segment + 1] - t0);
  return {from + slope * (t - t0), slope};
}

/// The parameter of the point of a ray that is closest to `point`.
double closestParameter(const RayMapRay& ray, const glm::dvec3& point) {
  double best = ray.tMin();
  double least = -1;
  for (size_t i = 0; i + 1 < ray.points.size(); ++i) {
    const glm::dvec3 from(ray.points[i]);
    const glm::dvec3 way = glm::dvec3(ray.points[i + 1]) - from;
    const double share = std::clamp(glm::dot(point - from, way) / std::max(glm::dot(way, way), 1e-300), 0.0, 1.0);
    const double distance = glm::distance(from + way * share, point);
    if (least < 0 || distance < least) {
      least = distance;
      best = ray.parameters[i] + share * (static_cast<double>(ray.parameters[i + 1]) - ray.parameters[i]);
    }
  }
  return best;
}

}  // namespace

glm::ivec2 quadCount(const RayMap& map) {
  const int columns = map.notes().wrapsAround ? map.width() : map.width() - 1;
  return {std::max(columns, 1), std::max(map.height() - 1, 1)};
}

RayMapQuad::RayMapQuad(const RayMap& map, int x, int y) {
  const int right = map.notes().wrapsAround ? (x + 1) % map.width() : std::min(x + 1, map.width() - 1);
  const int below = std::min(y + 1, map.height() - 1);
  rays_ = {map.ray(x, y), map.ray(right, y), map.ray(x, below), map.ray(right, below)};
  whole_ = std::none_of(rays_.begin(), rays_.end(), [](const RayMapRay& ray) { return ray.empty(); });
  if (whole_) {
    tMin_ = rays_[0].tMin();
    tMax_ = rays_[0].tMax();
    for (const RayMapRay& ray : rays_) {
      tMin_ = std::max(tMin_, static_cast<double>(ray.tMin()));
      tMax_ = std::min(tMax_, static_cast<double>(ray.tMax()));
    }
    whole_ = tMin_ < tMax_;
  }
}

glm::dvec3 RayMapQuad::pointAt(const glm::dvec2& ab, double t) const {
  const std::array<double, 4> weights = weightsAt(ab);
  glm::dvec3 sum(0);
  for (size_t i = 0; i < 4; ++i) {
    sum += pointAndSlope(rays_[i], t).point * weights[i];
  }
  return sum;
}

RayPath RayMapQuad::pathAt(const glm::dvec2& ab) const {
  std::vector<float> knots;
  const auto take = [&](const RayMapRay& ray) {
    std::copy_if(ray.parameters.begin(), ray.parameters.end(), std::back_inserter(knots),
                 [&](float t) { return static_cast<double>(t) > tMin_ && static_cast<double>(t) < tMax_; });
  };
  std::for_each(rays_.begin(), rays_.end(), take);
  std::sort(knots.begin(), knots.end());
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  if (knots.size() + 2 > RayPath::kMaxPoints) {
    knots.clear();
    take(rays_[(ab.x >= 0.5 ? 1u : 0u) + (ab.y >= 0.5 ? 2u : 0u)]);
  }
  RayPath path;
  path.add(glm::vec3(pointAt(ab, tMin_)), static_cast<float>(tMin_));
  for (const float t : knots) {
    path.add(glm::vec3(pointAt(ab, t)), t);
  }
  path.add(glm::vec3(pointAt(ab, tMax_)), static_cast<float>(tMax_));
  return path;
}

std::optional<glm::dvec3> RayMapQuad::solve(const glm::dvec3& point, const glm::dvec2& lower,
                                            const glm::dvec2& upper) const {
  constexpr int kMaxSteps = 40;
  constexpr int kMaxStepsAtLimit = 3;
  constexpr double kSettled = 1e-9;   // of a step, pixels
  constexpr double kBeyond = 1e-4;    // pixels: a point on the border of two quads has an image in one of them
  constexpr double kRounding = 1e-6;  // of parameters in single precision, as the ends of rays are stored
  constexpr double kAside = 1e-7;     // of coordinates: less than they are rounded by
  const double tolerance = kAside * (1 + std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}));
  glm::dvec2 ab = (lower + upper) * 0.5;
  double t = closestParameter(rays_[0], point);
  int stepsAtLimit = 0;
  // Newton's method: x is bilinear in a and b, and straight in t from one corner of a ray to the next.
  for (int step = 0; step < kMaxSteps; ++step) {
    const std::array<double, 4> weights = weightsAt(ab);
    std::array<PointAndSlope, 4> x;
    glm::dvec3 here(0);
    glm::dvec3 alongT(0);
    for (size_t i = 0; i < 4; ++i) {
      x[i] = pointAndSlope(rays_[i], t);
      here += x[i].point * weights[i];
      alongT += x[i].slope * weights[i];
    }
    const glm::dvec3 alongA = (x[1].point - x[0].point) * (1 - ab.y) + (x[3].point - x[2].point) * ab.y;
    const glm::dvec3 alongB = (x[2].point - x[0].point) * (1 - ab.x) + (x[3].point - x[1].point) * ab.x;
    const glm::dvec3 normal = glm::cross(alongA, alongB);
    const double volume = glm::dot(normal, alongT);
    if (!(std::abs(volume) > 0)) {
      return std::nullopt;
    }
    const glm::dvec3 aside = point - here;
    const glm::dvec3 change = glm::dvec3(glm::dot(glm::cross(alongB, alongT), aside),
                                         glm::dot(glm::cross(alongT, alongA), aside), glm::dot(normal, aside)) /
                              volume;
    if (std::max(std::abs(change.x), std::abs(change.y)) < kSettled && glm::length(aside) <= tolerance) {
      if (glm::any(glm::lessThan(ab, lower - kBeyond)) || glm::any(glm::greaterThan(ab, upper + kBeyond)) ||
          t < tMin_ - kRounding * (1 + std::abs(tMin_)) || t > tMax_ + kRounding * (1 + std::abs(tMax_))) {
        return std::nullopt;
      }
      return glm::dvec3(ab, std::clamp(t, tMin_, tMax_));
    }
    // Far from the quad the model says nothing: stay in its surroundings, and give up where all steps lead out of them.
    const glm::dvec2 next = glm::clamp(ab + glm::dvec2(change), lower - 1.0, upper + 1.0);
    stepsAtLimit = next == ab ? stepsAtLimit + 1 : 0;
    if (stepsAtLimit == kMaxStepsAtLimit) {
      return std::nullopt;
    }
    ab = next;
    t += change.z;
    if (!std::isfinite(t)) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<QuadPosition> quadPosition(const RayMap& map, const glm::dvec2& pixel) {
  if (!(pixel.x >= 0 && pixel.x <= map.width() && pixel.y >= 0 && pixel.y <= map.height())) {
    return std::nullopt;
  }
  const glm::dvec2 centred = pixel - 0.5;
  const auto first = [](double position, int pixels) {
    return pixels == 1 ? 0 : std::clamp(static_cast<int>(std::floor(position)), 0, pixels - 2);
  };
  QuadPosition found;
  if (map.notes().wrapsAround) {
    const double column = std::floor(centred.x);
    found.quad.x = (static_cast<int>(column) + map.width()) % map.width();
    found.ab.x = centred.x - column;
  } else {
    found.quad.x = first(centred.x, map.width());
    found.ab.x = map.width() == 1 ? 0 : centred.x - found.quad.x;
  }
  found.quad.y = first(centred.y, map.height());
  found.ab.y = map.height() == 1 ? 0 : centred.y - found.quad.y;
  found.nearest = {std::min(static_cast<int>(pixel.x), map.width() - 1),
                   std::min(static_cast<int>(pixel.y), map.height() - 1)};
  const auto isWhole = [](double share) { return share == 0 || share == 1; };
  found.onPixel = isWhole(found.ab.x) && isWhole(found.ab.y);
  return found;
}

QuadReach reachOf(const RayMap& map, const glm::ivec2& quad) {
  QuadReach reach;
  if (!map.notes().wrapsAround) {
    reach.lower.x = quad.x == 0 ? -0.5 : 0;
    reach.upper.x = quad.x == map.width() - 2 ? 1.5 : 1;
  }
  reach.lower.y = quad.y == 0 ? -0.5 : 0;
  reach.upper.y = quad.y == map.height() - 2 ? 1.5 : 1;
  return reach;
}

}  // namespace ocelli
