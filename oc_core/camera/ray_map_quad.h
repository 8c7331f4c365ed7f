// Four neighbouring rays of a map, and all rays between them: x(a, b, t) = sum of w_i(a, b) x_i(t), where a and b run
// from 0 to 1 from the first neighbour to the next, to the right and down (ray_map_camera.h).
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "oc_core/camera/ray_map.h"

namespace ocelli {

/// Where the map has quads: between pixel centres, and around where the last column is next to the first.
glm::ivec2 quadCount(const RayMap& map);

class RayMapQuad {
 public:
  /// Of the quad whose upper left pixel that is. Images of one column or row have quads without a width or height.
  RayMapQuad(const RayMap& map, int x, int y);

  /// Whether all four have rays, with parameters in common.
  bool whole() const { return whole_; }
  double tMin() const { return tMin_; }
  double tMax() const { return tMax_; }

  /// Of a whole quad.
  glm::dvec3 pointAt(const glm::dvec2& ab, double t) const;
  /// The polyline there: its corners are those of all four. At most as many as a RayPath holds: where they are more,
  /// the corners of the neighbour nearest to `ab`.
  RayPath pathAt(const glm::dvec2& ab) const;
  /// (a, b, t) of the ray that passes the point, of a whole quad; a and b from `lower` to `upper`.
  std::optional<glm::dvec3> solve(const glm::dvec3& point, const glm::dvec2& lower, const glm::dvec2& upper) const;

 private:
  std::array<RayMapRay, 4> rays_;
  bool whole_ = false;
  double tMin_ = 0;
  double tMax_ = 0;
};

/// The quad of a position in pixels of the map, and where in it; the one beside it where the position lies between the
/// outermost pixel centres and the border, so that a and b are beyond 0 and 1 there.
struct QuadPosition {
  glm::ivec2 quad{0};
  glm::dvec2 ab{0};
  glm::ivec2 nearest{0};  ///< pixel
  bool onPixel = false;   ///< whether the position is the centre of that pixel
};
/// Nothing beyond the borders.
std::optional<QuadPosition> quadPosition(const RayMap& map, const glm::dvec2& pixel);

/// The a and b that belong to a quad: 0 to 1, and half a pixel more at the borders of the image.
struct QuadReach {
  glm::dvec2 lower{0};
  glm::dvec2 upper{1};
};
QuadReach reachOf(const RayMap& map, const glm::ivec2& quad);

}  // namespace ocelli
