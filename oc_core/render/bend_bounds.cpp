#include "oc_core/render/bend_bounds.h"

#include <algorithm>
#include <array>

#include "oc_core/render/pixel_ray.h"

namespace ocelli {
namespace {

/// Points whose convex hull holds all rays of a bend: where those of the corners of the image cross its planes. An arc
/// lies in the hull of its control points.
std::vector<glm::dvec3> hullOf(const CurvedRayCamera& camera, size_t bend) {
  const double width = camera.width();
  const double height = camera.height();
  std::vector<glm::dvec3> points;
  for (const glm::dvec2 corner :
       {glm::dvec2(0, 0), glm::dvec2(width, 0), glm::dvec2(width, height), glm::dvec2(0, height)}) {
    const BendCorners c = cornersOf(camera, bend, corner);
    points.insert(points.end(), {c.t, c.s, c.q});
  }
  return points;
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

BendBounds::BendBounds(const CurvedRayCamera& camera, size_t bend) : before_(camera.pixelFromWorld(bend)) {
  const RayTransition& transition = camera.bends()[bend];
  const TransitionPlanes& planes = transition.planes();
  after_ = camera.pixelFromWorld(bend + 1) / -planes.middle.height(transition.beyond());
  slab_ = {beyond(planes.from), ocelli::before(planes.to)};
  const double width = camera.width();
  const double height = camera.height();
  const std::array<glm::dvec2, 4> image{glm::dvec2(0, 0), {width, 0}, {width, height}, {0, height}};
  HalfSpaces sides = within(image, before_, 2);
  const HalfSpaces sidesAfter = within(image, after_, 2);
  sides.insert(sides.end(), sidesAfter.begin(), sidesAfter.end());
  const std::vector<glm::dvec3> hull = hullOf(camera, bend);
  sides_ = around(hull, sides);
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& point : hull) {
    least = std::min(least, std::abs((before_ * glm::dvec4(point, 1)).w));
  }
  shortestEdge_ = 0.25 * least / static_cast<double>(camera.root().focalPixels());
}

void BendBounds::findBlocks(const MeshBlocks& blocks, uint32_t piece, std::vector<BlockTask>& tasks) const {
  HalfSpaces spaces = slab_;
  spaces.insert(spaces.end(), sides_.begin(), sides_.end());
  blocks.forEachWithin(spaces, [&](uint32_t block, Placement) { tasks.push_back({piece, block, false}); });
}

}  // namespace ocelli
