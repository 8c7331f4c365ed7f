#include "oc_core/constructor/frustum_image.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/constructor/image_parts.h"

namespace ocelli {
namespace {

/// How far beyond the plane of a frustum, in diagonals of a polygon, it has an image: there it is finite.
constexpr double kBeyondPlane = 1e-7;
/// How much smaller a part is made, pixels: more than corners that image_parts.h makes one.
constexpr double kPartInset = 5e-4;

GraphCamera::Part inset(const GraphCamera::Part& part) {
  GraphCamera::Part smaller = part;
  for (size_t k = 0; k < part.size() && !smaller.empty(); ++k) {
    const glm::dvec2 along = glm::normalize(part[(k + 1) % part.size()] - part[k]);
    const glm::dvec2 from = part[k] + glm::dvec2(-along.y, along.x) * kPartInset;
    smaller = GraphCamera::cut(smaller, from, from + along).first;
  }
  return smaller;
}

}  // namespace

GraphCamera::Part frustumImage(const GraphCamera& camera, int i, std::span<const glm::dvec3> corners) {
  const GraphCamera::Frustum& frustum = camera.frusta()[static_cast<size_t>(i)];
  GraphCamera::Part part;
  const double beyond = kBeyondPlane * glm::distance(corners[0], corners[corners.size() / 2]);
  for (size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec3& a = corners[k];
    const glm::dvec3& b = corners[(k + 1) % corners.size()];
    const double heightA = frustum.plane.height(a) - beyond;
    const double heightB = frustum.plane.height(b) - beyond;
    const auto add = [&](const glm::dvec3& point) {
      const glm::dvec4 h = frustum.pixelFromWorld * glm::dvec4(point, 1);
      part.push_back(glm::dvec2(h) / h.w);
    };
    if (heightA >= 0) {
      add(a);
    }
    if (heightA * heightB < 0) {
      add(a + (b - a) * (heightA / (heightA - heightB)));
    }
  }
  double twice = 0;
  for (size_t k = 0; k < part.size(); ++k) {
    const glm::dvec2& next = part[(k + 1) % part.size()];
    twice += part[k].x * next.y - part[k].y * next.x;
  }
  if (twice < 0) {
    std::reverse(part.begin(), part.end());
  }
  return common(part, frustum.part);
}

int bendWhereOneCan(GraphCamera& camera, int i, const GraphCamera::Bend& bend, const std::string& name,
                    const GraphCamera::Part& part) {
  for (const GraphCamera::Part& each : {part, inset(part)}) {
    if (each.empty()) {
      return -1;
    }
    try {
      return camera.bend(i, bend, name, each);
    } catch (const InputError&) {
      // The next one may do.
    }
  }
  return -1;
}

void limitWhereOneCan(GraphCamera& camera, int i, const Plane& limit) {
  try {
    camera.limit(i, limit);
  } catch (const InputError&) {
    // Rays begin beyond it.
  }
}

}  // namespace ocelli
