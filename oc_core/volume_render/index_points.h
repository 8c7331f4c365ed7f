// The points of a ray in the index coordinates of a volume, and which faces of its box they lie beyond, as many at once
// as the machine's vectors hold. For .cpp files.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "oc_core/camera/ray_path.h"

namespace ocelli {

/// In index coordinates.
struct IndexBox {
  glm::dvec3 lower;
  glm::dvec3 upper;

  static IndexBox everywhere() {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    return {glm::dvec3(-kFar), glm::dvec3(kFar)};
  }
};

struct IndexPoints {
  // Without initial values: there is room for as many as a ray may have, for every ray.
  alignas(64) std::array<double, RayPath::kMaxPoints> x;
  alignas(64) std::array<double, RayPath::kMaxPoints> y;
  alignas(64) std::array<double, RayPath::kMaxPoints> z;
  /// A bit for each face of the box that the point lies beyond; none for coordinates that are no numbers.
  alignas(64) std::array<uint64_t, RayPath::kMaxPoints> beyond;

  glm::dvec3 at(size_t i) const { return {x[i], y[i], z[i]}; }
};

/// Places the points of a ray. False, and `points` mean nothing, where all lie beyond one face of `box` or of `seen`,
/// so that the ray misses that.
bool placePoints(const RayPath& ray, const glm::dmat4& indexFromWorld, const IndexBox& box, const IndexBox& seen,
                 IndexPoints& points);

}  // namespace ocelli
