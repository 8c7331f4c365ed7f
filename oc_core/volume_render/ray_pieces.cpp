#include "oc_core/volume_render/ray_pieces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ocelli {
namespace {

/// Bits of the half spaces of the box that a point is not in.
unsigned outsideOf(const glm::dvec3& upper, const glm::dvec3& p) {
  return unsigned(p.x < -0.5) | unsigned(p.y < -0.5) << 1 | unsigned(p.z < -0.5) << 2 | unsigned(p.x > upper.x) << 3 |
         unsigned(p.y > upper.y) << 4 | unsigned(p.z > upper.z) << 5;
}

/// A half space cuts a segment: `from` and `to` are how far within it the ends lie. False where nothing is left.
bool narrow(double from, double to, SegmentPart& part) {
  if (from < 0 && to < 0) {
    return false;
  }
  if (from < 0) {
    part.first = std::max(part.first, from / (from - to));
  } else if (to < 0) {
    part.last = std::min(part.last, from / (from - to));
  }
  return part.first < part.last;
}

}  // namespace

VolumeExtent::VolumeExtent(const VolumeScene& scene)
    : scene_(scene),
      indexFromWorld_(glm::inverse(scene.worldFromIndex)),
      unitsByWorldLength_(1 / scene.sceneLengthOfUnit()),
      upper_(glm::dvec3(scene.volume->grid().size) - 0.5) {}

size_t VolumeExtent::cut(const RayPath& ray, double end, Pieces& pieces) const {
  size_t count = 0;
  if (ray.size() < 2) {
    return 0;
  }
  glm::dvec3 next(indexFromWorld_ * glm::dvec4(ray[0], 1));
  unsigned nextOutside = outsideOf(upper_, next);
  double lastEnd = -1;  // where the piece before ends: segments and shares of them
  for (size_t i = 0; i + 1 < ray.size(); ++i) {
    const glm::dvec3 from = next;
    const unsigned outside = nextOutside;
    next = glm::dvec3(indexFromWorld_ * glm::dvec4(ray[i + 1], 1));
    nextOutside = outsideOf(upper_, next);
    if ((outside & nextOutside) != 0) {
      continue;  // both ends lie beyond one face
    }
    const double t0 = static_cast<double>(ray.t(i));
    const double tLength = static_cast<double>(ray.t(i + 1)) - t0;
    if (t0 >= end) {
      break;
    }
    SegmentPart part;
    bool isSome = true;
    for (int axis = 0; axis < 3 && isSome && (outside | nextOutside) != 0; ++axis) {
      isSome = narrow(from[axis] + 0.5, next[axis] + 0.5, part) &&
               narrow(upper_[axis] - from[axis], upper_[axis] - next[axis], part);
    }
    const glm::dvec3 begin(ray[i]);
    const glm::dvec3 way = glm::dvec3(ray[i + 1]) - begin;
    for (size_t clip = 0; clip < scene_.clips.size() && isSome; ++clip) {
      const double height = glm::dot(scene_.clips[clip].normal, begin) - scene_.clips[clip].distance;
      isSome = narrow(height, height + glm::dot(scene_.clips[clip].normal, way), part);
    }
    if (isSome && t0 + tLength > end) {
      part.last = std::min(part.last, (end - t0) / tLength);
      isSome = part.first < part.last;
    }
    const double worldLength = glm::length(way);
    if (worldLength == 0 && lastEnd == static_cast<double>(i)) {
      lastEnd = static_cast<double>(i + 1);  // two points in one place
    }
    if (!isSome || !(worldLength > 0) || !std::isfinite(worldLength)) {
      continue;
    }
    const double length = worldLength * unitsByWorldLength_;
    const bool continues = part.first == 0 && lastEnd == static_cast<double>(i);
    pieces[count++] = {
        from + (next - from) * part.first, (next - from) / length, way / worldLength, length * (part.last - part.first),
        t0 + tLength * part.first,         tLength / length,       continues};
    lastEnd = static_cast<double>(i) + part.last;
  }
  return count;
}

}  // namespace ocelli
