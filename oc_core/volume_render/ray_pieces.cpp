#include "oc_core/volume_render/ray_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ocelli {
namespace {

/// The points of a ray in index coordinates, and for each the bits of the half spaces of the box that it is not in.
/// Loops of their own, which compilers turn into vectors.
struct IndexPoints {
  // Without initial values: there is room for as many as a ray may have, for every ray.
  std::array<double, RayPath::kMaxPoints> x;
  std::array<double, RayPath::kMaxPoints> y;
  std::array<double, RayPath::kMaxPoints> z;
  std::array<unsigned, RayPath::kMaxPoints> outside;

  /// The bits that all of them have.
  unsigned place(const RayPath& ray, const glm::dmat4& indexFromWorld, const glm::dvec3& upper) {
    const glm::dmat4& m = indexFromWorld;
    const size_t size = ray.size();
    const glm::vec3* const p = ray.begin();
    for (size_t i = 0; i < size; ++i) {
      const auto px = static_cast<double>(p[i].x);
      const auto py = static_cast<double>(p[i].y);
      const auto pz = static_cast<double>(p[i].z);
      x[i] = m[0][0] * px + m[1][0] * py + m[2][0] * pz + m[3][0];
      y[i] = m[0][1] * px + m[1][1] * py + m[2][1] * pz + m[3][1];
      z[i] = m[0][2] * px + m[1][2] * py + m[2][2] * pz + m[3][2];
    }
    unsigned all = ~0U;
    for (size_t i = 0; i < size; ++i) {
      outside[i] = unsigned(x[i] < -0.5) | unsigned(y[i] < -0.5) << 1 | unsigned(z[i] < -0.5) << 2 |
                   unsigned(x[i] > upper.x) << 3 | unsigned(y[i] > upper.y) << 4 | unsigned(z[i] > upper.z) << 5;
      all &= outside[i];
    }
    return all;
  }
  glm::dvec3 at(size_t i) const { return {x[i], y[i], z[i]}; }
};

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
  IndexPoints points;
  if (points.place(ray, indexFromWorld_, upper_) != 0) {
    return 0;  // all of it lies beyond one face, as most rays do where a volume is small
  }
  glm::dvec3 next = points.at(0);
  unsigned nextOutside = points.outside[0];
  double lastEnd = -1;  // where the piece before ends: segments and shares of them
  for (size_t i = 0; i + 1 < ray.size(); ++i) {
    const glm::dvec3 from = next;
    const unsigned outside = nextOutside;
    next = points.at(i + 1);
    nextOutside = points.outside[i + 1];
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
