#include "oc_core/constructor/image_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ocelli {
namespace {

using Part = GraphCamera::Part;

/// Square pixels: less shows nothing.
constexpr double kMinArea = 1e-3;
/// Corners nearer to each other than this are one, pixels: the edge between them has no direction to rely on.
constexpr double kMinEdge = 1e-4;
/// Of the distances to zNear and zFar, so that rays cross what is seen strictly between them.
constexpr double kDepthMargin = 1e-3;

Part tidied(const Part& part) {
  Part kept;
  for (const glm::dvec2& corner : part) {
    if (kept.empty() || glm::distance(kept.back(), corner) > kMinEdge) {
      kept.push_back(corner);
    }
  }
  while (kept.size() > 1 && glm::distance(kept.back(), kept.front()) <= kMinEdge) {
    kept.pop_back();
  }
  return kept.size() >= 3 && areaOf(kept) >= kMinArea ? kept : Part{};
}

/// Where z >= least, or z <= least with `sign` -1.
std::vector<glm::dvec3> clippedAtDepth(const std::vector<glm::dvec3>& corners, double least, double sign) {
  std::vector<glm::dvec3> kept;
  for (size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& a = corners[i];
    const glm::dvec3& b = corners[(i + 1) % corners.size()];
    const double insideA = sign * (a.z - least);
    const double insideB = sign * (b.z - least);
    if (insideA >= 0) {
      kept.push_back(a);
    }
    if (insideA * insideB < 0) {
      kept.push_back(a + (b - a) * (insideA / (insideA - insideB)));
    }
  }
  return kept;
}

}  // namespace

double areaOf(const Part& part) {
  double twice = 0;
  for (size_t i = 0; i < part.size(); ++i) {
    const glm::dvec2& a = part[i];
    const glm::dvec2& b = part[(i + 1) % part.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

Part imagePart(std::span<const glm::dvec3> corners, const PinholeCamera& camera) {
  std::vector<glm::dvec3> polygon;
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 p = corner - glm::dvec3(camera.eye());
    polygon.emplace_back(glm::dot(p, glm::dvec3(camera.right())), glm::dot(p, glm::dvec3(camera.down())),
                         glm::dot(p, glm::dvec3(camera.forward())));
  }
  polygon = clippedAtDepth(polygon, static_cast<double>(camera.view().zNear) * (1 + kDepthMargin), 1);
  polygon = clippedAtDepth(polygon, static_cast<double>(camera.view().zFar) * (1 - kDepthMargin), -1);
  Part part;
  for (const glm::dvec3& p : polygon) {
    part.push_back(glm::dvec2(camera.centerPixels()) +
                   glm::dvec2(p) * (static_cast<double>(camera.focalPixels()) / p.z));
  }
  if (areaOf(part) < 0) {
    std::reverse(part.begin(), part.end());
  }
  const double width = camera.width();
  const double height = camera.height();
  return common(part, {{0, 0}, {width, 0}, {width, height}, {0, height}});
}

Part common(const Part& part, const Part& other) {
  Part shared = tidied(part);
  for (size_t i = 0; i < other.size() && !shared.empty(); ++i) {
    shared = GraphCamera::cut(shared, other[i], other[(i + 1) % other.size()]).first;
  }
  return other.empty() ? Part{} : tidied(shared);
}

std::vector<Part> less(const Part& part, const Part& other) {
  if (common(part, other).empty()) {
    return tidied(part).empty() ? std::vector<Part>{} : std::vector<Part>{tidied(part)};
  }
  std::vector<Part> pieces;
  Part rest = part;
  for (size_t i = 0; i < other.size() && !rest.empty(); ++i) {
    auto [inside, outside] = GraphCamera::cut(rest, other[i], other[(i + 1) % other.size()]);
    outside = tidied(outside);
    if (!outside.empty()) {
      pieces.push_back(std::move(outside));
    }
    rest = std::move(inside);
  }
  return pieces;
}

}  // namespace ocelli
