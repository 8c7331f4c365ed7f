#include "oc_core/volume_render/ray_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

namespace ocelli {
namespace {

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
      worldLengthOfUnit_(scene.sceneLengthOfUnit()),
      unitsByWorldLength_(1 / worldLengthOfUnit_),
      box_{glm::dvec3(-0.5), glm::dvec3(scene.volume->grid().size) - 0.5},
      seen_(box_) {}

void VolumeExtent::setSeen(const IndexBox& box) {
  seen_ = {glm::max(box_.lower, box.lower), glm::min(box_.upper, box.upper)};
}

bool VolumeExtent::misses(const HullPieces& hull) const {
  const glm::dvec3 lower = glm::max(box_.lower, seen_.lower);
  const glm::dvec3 upper = glm::min(box_.upper, seen_.upper);
  for (size_t piece = 0; piece < hull.ends.size(); ++piece) {
    glm::bvec3 below(true);
    glm::bvec3 above(true);
    for (const glm::dvec3& point : hull.piece(piece)) {
      const glm::dvec3 p(indexFromWorld_ * glm::dvec4(point, 1));
      // By so much may the points of rays, in single precision, lie beside.
      const glm::dvec3 room =
          4.0 * std::numeric_limits<float>::epsilon() *
          (glm::abs(glm::dvec3(indexFromWorld_[0]) * point.x) + glm::abs(glm::dvec3(indexFromWorld_[1]) * point.y) +
           glm::abs(glm::dvec3(indexFromWorld_[2]) * point.z));
      for (int axis = 0; axis < 3; ++axis) {
        below[axis] = below[axis] && p[axis] + room[axis] < lower[axis];
        above[axis] = above[axis] && p[axis] - room[axis] > upper[axis];
      }
    }
    if (!glm::any(below) && !glm::any(above)) {
      return false;
    }
  }
  return true;
}

size_t VolumeExtent::cut(const RayPath& ray, double end, Pieces& pieces) const {
  size_t count = 0;
  if (ray.size() < 2) {
    return 0;
  }
  IndexPoints points;
  // Most rays miss what is seen where that is small. The pieces of all others are cut to the volume, so that what is
  // seen does not decide where samples lie.
  if (!placePoints(ray, indexFromWorld_, box_, seen_, points)) {
    return 0;
  }
  glm::dvec3 next = points.at(0);
  uint64_t nextBeyond = points.beyond[0];
  double lastEnd = -1;  // where the piece before ends: segments and shares of them
  for (size_t i = 0; i + 1 < ray.size(); ++i) {
    const glm::dvec3 from = next;
    const uint64_t beyond = nextBeyond;
    next = points.at(i + 1);
    nextBeyond = points.beyond[i + 1];
    if ((beyond & nextBeyond) != 0) {
      continue;  // both ends lie beyond one face
    }
    const double t0 = static_cast<double>(ray.t(i));
    const double tLength = static_cast<double>(ray.t(i + 1)) - t0;
    if (t0 >= end) {
      break;
    }
    SegmentPart part;
    bool isSome = true;
    for (int axis = 0; axis < 3 && isSome && (beyond | nextBeyond) != 0; ++axis) {
      isSome = narrow(from[axis] - box_.lower[axis], next[axis] - box_.lower[axis], part) &&
               narrow(box_.upper[axis] - from[axis], box_.upper[axis] - next[axis], part);
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
    const double perWorldLength = 1 / worldLength;
    const double perLength = perWorldLength * worldLengthOfUnit_;
    const glm::dvec3 indexWay = next - from;
    const bool continues = part.first == 0 && lastEnd == static_cast<double>(i);
    pieces[count++] = {from + indexWay * part.first,
                       indexWay * perLength,
                       way * perWorldLength,
                       worldLength * unitsByWorldLength_ * (part.last - part.first),
                       t0 + tLength * part.first,
                       tLength * perLength,
                       continues};
    lastEnd = static_cast<double>(i) + part.last;
  }
  return count;
}

}  // namespace ocelli
