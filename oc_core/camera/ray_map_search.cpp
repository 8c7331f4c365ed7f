#include "oc_core/camera/ray_map_search.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>

#include "oc_core/base/parallel.h"
#include "oc_core/camera/ray_map_quad.h"

namespace ocelli {
namespace {

constexpr size_t kMaxCorners = 17;
constexpr size_t kLookedAt = 1 << 16;  ///< parameters that corners are chosen from
/// Of lengths and coordinates: bounds are worked out in double precision, and kept in single. As far beyond the ends of
/// rays a point may be (RayMapQuad::solve()).
constexpr double kRoundUp = 1e-6;
/// Of radii, which are a few pixels: solve() goes less beyond the border of a quad.
constexpr double kMargin = 1e-3;

/// The point at a parameter; the nearer end for parameters beyond an end.
glm::dvec3 clampedPoint(const RayMapRay& ray, double t) {
  if (t <= static_cast<double>(ray.tMin())) {
    return glm::dvec3(ray.points.front());
  }
  if (t >= static_cast<double>(ray.tMax())) {
    return glm::dvec3(ray.points.back());
  }
  const auto next = std::upper_bound(ray.parameters.begin(), ray.parameters.end(), t,
                                     [](double value, float knot) { return value < knot; });
  const auto i = static_cast<size_t>(next - ray.parameters.begin());
  const auto t0 = static_cast<double>(ray.parameters[i - 1]);
  return glm::mix(glm::dvec3(ray.points[i - 1]), glm::dvec3(ray.points[i]), (t - t0) / (ray.parameters[i] - t0));
}

/// Where rays of the map bend and end: all such parameters where they are few, otherwise as many as chains have, with
/// equally many between each two.
std::vector<float> chainParameters(const RayMap& map) {
  const size_t pixels = static_cast<size_t>(map.width()) * static_cast<size_t>(map.height());
  const size_t step = std::max<size_t>(1, pixels * (map.maxSegments() + 1) / kLookedAt);
  std::vector<float> all;
  float least = 0;
  float greatest = 0;
  bool first = true;
  size_t number = 0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const RayMapRay ray = map.ray(x, y);
      if (ray.empty()) {
        continue;
      }
      least = first ? ray.tMin() : std::min(least, ray.tMin());
      greatest = first ? ray.tMax() : std::max(greatest, ray.tMax());
      if (number++ % step == 0) {
        all.insert(all.end(), ray.parameters.begin(), ray.parameters.end());
      }
      first = false;
    }
  }
  all.insert(all.end(), {least, greatest});
  std::sort(all.begin(), all.end());
  std::vector<float> different;
  std::unique_copy(all.begin(), all.end(), std::back_inserter(different));
  if (different.size() > kMaxCorners) {
    different.clear();
    for (size_t i = 0; i < kMaxCorners; ++i) {
      different.push_back(all[i * (all.size() - 1) / (kMaxCorners - 1)]);
    }
    different.erase(std::unique(different.begin(), different.end()), different.end());
  }
  return different;
}

}  // namespace

RayMapSearch::RayMapSearch(const RayMap& map) : parameters_(chainParameters(map)) {
  glm::ivec2 size = (quadCount(map) + kBlockSide - 1) / kBlockSide;
  size_t nodes = 0;
  while (true) {
    levels_.push_back({size, nodes});
    nodes += static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
    if (size == glm::ivec2(1)) {
      break;
    }
    size = (size + 1) / 2;
  }
  balls_.resize(nodes * corners());
  deviations_.resize(nodes * (corners() - 1));
  for (size_t level = 0; level < levels_.size(); ++level) {
    const glm::ivec2 all = levels_[level].size;
    parallelFor(static_cast<size_t>(all.y), 1, [&](size_t begin, size_t end) {
      for (size_t y = begin; y < end; ++y) {
        for (int x = 0; x < all.x; ++x) {
          if (level == 0) {
            boundBlock(map, {x, static_cast<int>(y)});
          } else {
            boundChildren(level, {x, static_cast<int>(y)});
          }
        }
      }
    });
  }
}

void RayMapSearch::boundBlock(const RayMap& map, const glm::ivec2& block) {
  const glm::ivec2 lower = block * kBlockSide;
  const glm::ivec2 upper = glm::min(lower + kBlockSide, quadCount(map));  // of quads, whose pixels are one more
  std::vector<RayMapRay> rays;
  for (int y = lower.y; y <= std::min(upper.y, map.height() - 1); ++y) {
    for (int x = lower.x; x <= upper.x; ++x) {
      const int column = map.notes().wrapsAround ? x % map.width() : std::min(x, map.width() - 1);
      if (const RayMapRay ray = map.ray(column, y); !ray.empty()) {
        rays.push_back(ray);
      }
    }
  }
  if (rays.empty()) {
    return;
  }
  // Weights of neighbours up to half a pixel beyond the outermost pixel centre are -0.5 and 1.5: their sizes sum up to
  // 2 along each axis, and so much farther than the neighbours a ray can be from the middle.
  double factor = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const bool atBorder = lower[axis] == 0 || upper[axis] == quadCount(map)[axis];
    factor *= atBorder && !(axis == 0 && map.notes().wrapsAround) ? 2 : 1;
  }
  const size_t node = nodeOf(0, block);
  Ball* balls = &balls_[node * corners()];
  for (size_t k = 0; k < corners(); ++k) {
    const auto t = static_cast<double>(parameters_[k]);
    glm::dvec3 least = clampedPoint(rays[0], t);
    glm::dvec3 greatest = least;
    for (const RayMapRay& ray : rays) {
      least = glm::min(least, clampedPoint(ray, t));
      greatest = glm::max(greatest, clampedPoint(ray, t));
    }
    const auto centre = glm::vec3((least + greatest) * 0.5);
    double radius = 0;
    for (const RayMapRay& ray : rays) {
      radius = std::max(radius, glm::distance(glm::dvec3(centre), clampedPoint(ray, t)));
    }
    balls[k] = {centre, static_cast<float>(radius * factor * (1 + kMargin))};
  }
  for (size_t k = 0; k + 1 < corners(); ++k) {
    const auto t0 = static_cast<double>(parameters_[k]);
    const auto t1 = static_cast<double>(parameters_[k + 1]);
    double deviation = 0;
    for (const RayMapRay& ray : rays) {
      for (const float t : ray.parameters) {
        if (static_cast<double>(t) > t0 && static_cast<double>(t) < t1) {
          const glm::dvec3 chord = glm::mix(clampedPoint(ray, t0), clampedPoint(ray, t1), (t - t0) / (t1 - t0));
          deviation = std::max(deviation, glm::distance(chord, clampedPoint(ray, t)));
        }
      }
    }
    deviations_[node * (corners() - 1) + k] = static_cast<float>(deviation * factor * (1 + kMargin));
  }
}

void RayMapSearch::boundChildren(size_t level, const glm::ivec2& at) {
  const glm::ivec2 lower = at * 2;
  const glm::ivec2 upper = glm::min(lower + 2, levels_[level - 1].size);
  std::vector<size_t> children;
  for (int y = lower.y; y < upper.y; ++y) {
    for (int x = lower.x; x < upper.x; ++x) {
      const size_t child = nodeOf(level - 1, {x, y});
      if (balls_[child * corners()].radius >= 0) {
        children.push_back(child);
      }
    }
  }
  if (children.empty()) {
    return;
  }
  const size_t node = nodeOf(level, at);
  for (size_t k = 0; k < corners(); ++k) {
    glm::dvec3 sum(0);
    for (const size_t child : children) {
      sum += glm::dvec3(balls_[child * corners() + k].centre);
    }
    const auto centre = glm::vec3(sum / static_cast<double>(children.size()));
    double radius = 0;
    for (const size_t child : children) {
      const Ball& ball = balls_[child * corners() + k];
      radius = std::max(radius, glm::distance(glm::dvec3(centre), glm::dvec3(ball.centre)) + ball.radius);
    }
    balls_[node * corners() + k] = {centre, static_cast<float>(radius * (1 + kRoundUp))};
  }
  for (size_t k = 0; k + 1 < corners(); ++k) {
    float& deviation = deviations_[node * (corners() - 1) + k];
    for (const size_t child : children) {
      deviation = std::max(deviation, deviations_[child * (corners() - 1) + k]);
    }
  }
}

bool RayMapSearch::mayHold(size_t node, const glm::dvec3& point) const {
  const Ball* balls = &balls_[node * corners()];
  if (balls[0].radius < 0) {
    return false;
  }
  for (size_t k = 0; k + 1 < corners(); ++k) {
    const glm::dvec3 from(balls[k].centre);
    const glm::dvec3 way = glm::dvec3(balls[k + 1].centre) - from;
    const glm::dvec3 aside = point - from;
    const double rounding = kRoundUp * (1 + glm::length(point));
    const double radius = static_cast<double>(balls[k].radius) + deviations_[node * (corners() - 1) + k] + rounding;
    const double growth = static_cast<double>(balls[k + 1].radius) - balls[k].radius;
    // Whether |aside - s way| is within radius + s growth for an s from 0 to 1: at an end, or where the difference of
    // their squares is least.
    const auto within = [&](double s) { return glm::length(aside - way * s) <= radius + growth * s; };
    const double a = glm::dot(way, way) - growth * growth;
    if (within(0) || within(1 + kRoundUp) ||
        (a > 0 && within(std::clamp((glm::dot(aside, way) + radius * growth) / a, 0.0, 1.0)))) {
      return true;
    }
  }
  return false;
}

std::vector<glm::ivec2> RayMapSearch::blocksNear(const glm::dvec3& point) const {
  struct Node {
    size_t level;
    glm::ivec2 at;
  };
  std::vector<glm::ivec2> blocks;
  std::vector<Node> open{{levels_.size() - 1, {0, 0}}};
  while (!open.empty()) {
    const Node node = open.back();
    open.pop_back();
    if (!mayHold(nodeOf(node.level, node.at), point)) {
      continue;
    }
    if (node.level == 0) {
      blocks.push_back(node.at);
      continue;
    }
    const glm::ivec2 upper = glm::min(node.at * 2 + 2, levels_[node.level - 1].size);
    for (int y = node.at.y * 2; y < upper.y; ++y) {
      for (int x = node.at.x * 2; x < upper.x; ++x) {
        open.push_back({node.level - 1, {x, y}});
      }
    }
  }
  return blocks;
}

}  // namespace ocelli
