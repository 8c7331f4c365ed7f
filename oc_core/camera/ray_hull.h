// Where the rays of many pixels run, without making them: for leaving out those that cannot meet what is drawn.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {

/// Convex pieces, one behind the other, that together hold some rays: each is the convex hull of points.
struct HullPieces {
  std::vector<glm::dvec3> points;
  std::vector<size_t> ends;  ///< of each piece, in `points`; the next one begins there

  void endPiece() { ends.push_back(points.size()); }
  std::span<const glm::dvec3> piece(size_t i) const {
    const size_t begin = i == 0 ? 0 : ends[i - 1];
    return std::span(points).subspan(begin, ends[i] - begin);
  }
};

/// What holds the rays of all pixels from `lower` to `upper`, corners of a rectangle in pixels, up to rounding of the
/// rays to single precision. A camera has one where there is a function `hullOf(camera, lower, upper)`.
using RayHull = std::function<HullPieces(const glm::dvec2& lower, const glm::dvec2& upper)>;

/// The ends of the rays through the corners.
HullPieces hullOf(const PinholeCamera& camera, const glm::dvec2& lower, const glm::dvec2& upper);

/// That of a camera, which the function keeps; none where the camera has none.
template <class C>
RayHull rayHullOf(const std::shared_ptr<const C>& camera) {
  if constexpr (requires { hullOf(*camera, glm::dvec2(0), glm::dvec2(1)); }) {
    return [camera](const glm::dvec2& lower, const glm::dvec2& upper) { return hullOf(*camera, lower, upper); };
  } else {
    return {};
  }
}

}  // namespace ocelli
