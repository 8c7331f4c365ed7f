#include "oc_core/volume_render/ray_tile.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "oc_core/volume/volume_bricks.h"

namespace ocelli {
namespace {

float between(float a, float b, float share) {
  return a + (b - a) * share;
}

/// Shares of the way from `from` to `to` between which it lies in the ball. Nothing where it does not.
std::optional<std::array<double, 2>> partIn(const TileBall& ball, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 way = to - from;
  const glm::dvec3 away = from - ball.center;
  const double length2 = glm::dot(way, way);
  const double middle = -glm::dot(away, way);
  const double root2 = middle * middle - length2 * (glm::dot(away, away) - ball.radius * ball.radius);
  if (!(length2 > 0) || !(root2 > 0)) {
    return std::nullopt;
  }
  const double root = std::sqrt(root2);
  const double begin = std::max((middle - root) / length2, 0.0);
  const double end = std::min((middle + root) / length2, 1.0);
  return begin < end ? std::optional(std::array{begin, end}) : std::nullopt;
}

/// Whether two rays, share by share of their segments, are nowhere in the ball farther apart, nor are their parameters.
bool areNear(const RayPath& a, const RayPath& b, const TileBall& ball, double deviation) {
  if (a.size() != b.size()) {
    return false;
  }
  const auto difference = [&](size_t i) {
    return glm::dvec4(glm::dvec3(a[i]) - glm::dvec3(b[i]), static_cast<double>(a.t(i)) - static_cast<double>(b.t(i)));
  };
  for (size_t i = 0; i + 1 < a.size(); ++i) {
    const std::optional<std::array<double, 2>> part = partIn(ball, glm::dvec3(a[i]), glm::dvec3(a[i + 1]));
    if (!part) {
      continue;
    }
    // It changes linearly between the ends, so it is greatest at one of them.
    for (const double share : *part) {
      if (!(glm::length(glm::mix(difference(i), difference(i + 1), share)) <= deviation)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

bool RayTile::fit(const Rays& rays, const glm::vec2& first, const glm::vec2& last, const TileBall& ball,
                  double deviation) {
  if (!(first.x < last.x) || !(first.y < last.y)) {
    return false;
  }
  first_ = first;
  perSize_ = 1.0f / (last - first);
  upper_ = {rays(first), rays({last.x, first.y})};
  lower_ = {rays({first.x, last.y}), rays(last)};
  const size_t size = upper_[0].size();
  if (size < 2 || upper_[1].size() != size || lower_[0].size() != size || lower_[1].size() != size) {
    return false;
  }
  // What is bilinear is farthest from a smooth surface near its middle, or near the middles of its sides.
  const glm::vec2 middle = (first + last) * 0.5f;
  const std::array<glm::vec2, 3> checked{middle, {middle.x, first.y}, {first.x, middle.y}};
  return std::all_of(checked.begin(), checked.end(),
                     [&](const glm::vec2& pixel) { return areNear(rays(pixel), at(pixel), ball, deviation); });
}

RayPath RayTile::at(const glm::vec2& pixel) const {
  const glm::vec2 share = (pixel - first_) * perSize_;
  RayPath path;
  for (size_t i = 0; i < upper_[0].size(); ++i) {
    const glm::vec3 above = glm::mix(upper_[0][i], upper_[1][i], share.x);
    const glm::vec3 below = glm::mix(lower_[0][i], lower_[1][i], share.x);
    path.add(glm::mix(above, below, share.y), between(between(upper_[0].t(i), upper_[1].t(i), share.x),
                                                      between(lower_[0].t(i), lower_[1].t(i), share.x), share.y));
  }
  return path;
}

TileSight::TileSight(const VolumeOccupancy& occupancy, const glm::dmat4& indexFromWorld, double room)
    : occupancy_(occupancy), indexFromWorld_(indexFromWorld), room_(room) {}

bool TileSight::meets(const RayTile& tile) const {
  const auto placed = [&](size_t i) {
    const auto place = [&](const RayPath& ray) { return glm::dvec3(indexFromWorld_ * glm::dvec4(ray[i], 1)); };
    return std::array{place(tile.upper()[0]), place(tile.upper()[1]), place(tile.lower()[0]), place(tile.lower()[1])};
  };
  constexpr int kSplits = 16;  // so many halves of a piece are a small part of a voxel
  std::array<glm::dvec3, 4> from = placed(0);
  for (size_t i = 1; i < tile.upper()[0].size(); ++i) {
    const std::array<glm::dvec3, 4> to = placed(i);
    if (meets({from, to}, kSplits)) {
      return true;
    }
    from = to;
  }
  return false;
}

// A point of a ray between two corners of its polyline is as bilinear between those of the tile's corners as these are:
// it lies in the hull of the eight points, and so does what is cut off at equal shares.
bool TileSight::meets(const Block& block, int splits) const {
  glm::dvec3 lower = block.from[0];
  glm::dvec3 upper = lower;
  for (size_t i = 0; i < block.from.size(); ++i) {
    lower = glm::min(lower, glm::min(block.from[i], block.to[i]));
    upper = glm::max(upper, glm::max(block.from[i], block.to[i]));
  }
  constexpr double kEdge = VolumeBricks::kEdge;
  const glm::dvec3 size(occupancy_.size());
  const glm::dvec3 first = glm::floor((lower - room_) / kEdge);
  const glm::dvec3 last = glm::floor((upper + room_) / kEdge);
  // Outermost bricks reach as far as the volume does, half a voxel beyond the centres.
  const glm::dvec3 firstSeen(occupancy_.firstSeen());
  const glm::dvec3 endSeen(occupancy_.endSeen());
  for (int axis = 0; axis < 3; ++axis) {
    if ((last[axis] < firstSeen[axis] && firstSeen[axis] > 0) ||
        (first[axis] >= endSeen[axis] && endSeen[axis] < size[axis])) {
      return false;
    }
    // No number, or beyond the volume.
    if (!(upper[axis] + room_ >= -0.5) || !(lower[axis] - room_ <= size[axis] * kEdge)) {
      return !(upper[axis] - lower[axis] < 1e30);
    }
  }
  const glm::ivec3 begin(glm::clamp(first, glm::dvec3(0), size - 1.0));
  const glm::ivec3 end(glm::clamp(last, glm::dvec3(0), size - 1.0));
  const glm::ivec3 middle = (begin + end) / 2;
  const auto distance = [&](const glm::ivec3& brick) {
    const glm::ivec3& bricks = occupancy_.size();
    return static_cast<int>(
        occupancy_
            .distances()[(static_cast<size_t>(brick.z) * static_cast<size_t>(bricks.y) + static_cast<size_t>(brick.y)) *
                             static_cast<size_t>(bricks.x) +
                         static_cast<size_t>(brick.x)]);
  };
  const glm::ivec3 reach = end - middle;
  if (distance(middle) > std::max({reach.x, reach.y, reach.z})) {
    return false;
  }
  constexpr int kFew = 12;
  const glm::ivec3 count = end - begin + 1;
  if (count.x * count.y * count.z <= kFew || splits == 0) {
    for (int k = begin.z; k <= end.z; ++k) {
      for (int j = begin.y; j <= end.y; ++j) {
        for (int i = begin.x; i <= end.x; ++i) {
          if (distance({i, j, k}) == 0) {
            return true;
          }
        }
      }
    }
    return false;
  }
  Block near = block;
  Block far = block;
  for (size_t i = 0; i < block.from.size(); ++i) {
    near.to[i] = far.from[i] = (block.from[i] + block.to[i]) * 0.5;
  }
  return meets(near, splits - 1) || meets(far, splits - 1);
}

}  // namespace ocelli
