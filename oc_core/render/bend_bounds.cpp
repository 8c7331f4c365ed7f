#include "oc_core/render/bend_bounds.h"

#include <algorithm>
#include <array>

#include "oc_core/render/pixel_ray.h"

namespace ocelli {
namespace {

/// How far beyond a part of the image something may be and still be drawn to its pixels, pixels: many times what
/// BendRasterizer::kErrorPixels and rounding leave.
constexpr double kSidesMargin = 2;

/// The corners of a part of the image, clockwise as seen.
using Corners = std::array<glm::dvec2, 4>;

Corners cornersOf(const glm::dvec2& lower, const glm::dvec2& upper) {
  return {lower, {upper.x, lower.y}, upper, {lower.x, upper.y}};
}

/// Points whose convex hull holds all rays of a bend that pass a part of the image: where those of its corners cross
/// the planes of the bend. An arc lies in the hull of its control points.
std::vector<glm::dvec3> hullOf(const CurvedRayCamera& camera, size_t bend, const Corners& part) {
  std::vector<glm::dvec3> points;
  for (const glm::dvec2& corner : part) {
    const BendCorners c = cornersOf(camera, bend, corner);
    points.insert(points.end(), {c.t, c.s, c.q});
  }
  return points;
}

/// Half spaces that a part of the image has about it, as straight rays before and after a bend have it.
HalfSpaces sidesBy(const Corners& part, const glm::dmat4& before, const glm::dmat4& after) {
  HalfSpaces sides = within(part, before, kSidesMargin);
  const HalfSpaces sidesAfter = within(part, after, kSidesMargin);
  sides.insert(sides.end(), sidesAfter.begin(), sidesAfter.end());
  return sides;
}

/// Half spaces around a hull: those given, moved outwards where they must be, and an axis-aligned box.
HalfSpaces around(const std::vector<glm::dvec3>& hull, const HalfSpaces& candidates) {
  HalfSpaces spaces = candidates;
  Box box;
  for (const glm::dvec3& point : hull) {
    box.add(glm::vec3(point));
  }
  const glm::vec3 room = box.size() * 0.01f;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 normal(0);
    normal[axis] = 1;
    spaces.emplace_back(normal, static_cast<double>(room[axis] - box.lower[axis]));
    spaces.emplace_back(-normal, static_cast<double>(room[axis] + box.upper[axis]));
  }
  for (HalfSpace& space : spaces) {
    for (const glm::dvec3& point : hull) {
      space.w -= std::min(glm::dot(space, glm::dvec4(point, 1)), 0.0);
    }
  }
  return spaces;
}

}  // namespace

BendCorners cornersOf(const CurvedRayCamera& camera, size_t bend, const glm::dvec2& pixel) {
  PixelRay ray(PixelRays(camera.root()), pixel);
  for (size_t i = 0; i < bend; ++i) {
    ray.bend(camera.bends()[i].planes().middle, camera.bends()[i].beyond());
  }
  const TransitionPlanes& planes = camera.bends()[bend].planes();
  BendCorners corners{ray.cross(planes.from), ray.cross(planes.middle), {}};
  ray.bend(planes.middle, camera.bends()[bend].beyond());
  corners.q = ray.cross(planes.to);
  return corners;
}

BendBounds::BendBounds(const CurvedRayCamera& camera, size_t bend) : bend_(bend), before_(camera.pixelFromWorld(bend)) {
  const RayTransition& transition = camera.bends()[bend];
  const TransitionPlanes& planes = transition.planes();
  after_ = camera.pixelFromWorld(bend + 1) / -planes.middle.height(transition.beyond());
  slab_ = {beyond(planes.from), ocelli::before(planes.to)};
  const Corners image = cornersOf({0, 0}, {camera.width(), camera.height()});
  const std::vector<glm::dvec3> hull = hullOf(camera, bend, image);
  sides_ = around(hull, sidesBy(image, before_, after_));
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& point : hull) {
    least = std::min(least, std::abs((before_ * glm::dvec4(point, 1)).w));
  }
  shortestEdge_ = 0.25 * least / static_cast<double>(camera.root().focalPixels());
}

HalfSpaces BendBounds::spaces() const {
  HalfSpaces spaces = slab_;
  spaces.insert(spaces.end(), sides_.begin(), sides_.end());
  return spaces;
}

HalfSpaces BendBounds::sidesOf(const CurvedRayCamera& camera, const PixelBounds& rect) const {
  // Not beyond the image: only there it is known that rays cross the planes in order.
  const glm::dvec2 size(camera.width(), camera.height());
  const Corners part = cornersOf(glm::max(glm::dvec2(rect.x0, rect.y0) - kSidesMargin, glm::dvec2(0)),
                                 glm::min(glm::dvec2(rect.x1, rect.y1) + kSidesMargin, size));
  return around(hullOf(camera, bend_, part), sidesBy(part, before_, after_));
}

float BendBounds::leastShare(const Box& box) const {
  const glm::dvec3 half = (glm::dvec3(box.upper) - glm::dvec3(box.lower)) * 0.5;
  const glm::dvec4 middle(glm::dvec3(box.lower) + half, 1);
  const auto reach = [&](const HalfSpace& space) { return glm::dot(glm::abs(glm::dvec3(space)), half); };
  const double first = glm::dot(slab_[0], middle) - reach(slab_[0]);
  const double last = std::max(glm::dot(slab_[1], middle) + reach(slab_[1]), 0.0);
  constexpr double kRoom = 1e-4;  // a thousand times what single precision rounds by
  return first > 0 ? static_cast<float>((1 - kRoom) * first / (first + last)) : 0;
}

}  // namespace ocelli
