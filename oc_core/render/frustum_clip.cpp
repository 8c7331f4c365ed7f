#include "oc_core/render/frustum_clip.h"

#include <algorithm>

#include "oc_core/base/finite.h"

namespace ocelli {
namespace {

/// A vertex while it is clipped: in double precision, so that corners far away do not move the cut next to the eye.
struct Corner {
  glm::dvec3 p;
  double b1 = 0;
  double b2 = 0;
};

struct Polygon {
  std::array<Corner, ClipPolygon::kMax> corners;
  size_t count = 0;
};

/// Sutherland-Hodgman against one plane: keeps where dot(normal, p) + offset >= 0. A cut is computed from its inner end
/// to its outer one, so triangles that share an edge cut it at the same point, in whatever direction they run along it.
Polygon clip(const Polygon& polygon, const glm::dvec3& normal, double offset) {
  Polygon kept;
  for (size_t i = 0; i < polygon.count; ++i) {
    const Corner& a = polygon.corners[i];
    const Corner& b = polygon.corners[(i + 1) % polygon.count];
    const double da = glm::dot(normal, a.p) + offset;
    const double db = glm::dot(normal, b.p) + offset;
    if (da >= 0 && kept.count < ClipPolygon::kMax) {
      kept.corners[kept.count++] = a;
    }
    if ((da >= 0) != (db >= 0) && kept.count < ClipPolygon::kMax) {
      const Corner& inner = da >= 0 ? a : b;
      const Corner& outer = da >= 0 ? b : a;
      const double t = da >= 0 ? da / (da - db) : db / (db - da);
      kept.corners[kept.count++] = {inner.p + (outer.p - inner.p) * t, inner.b1 + (outer.b1 - inner.b1) * t,
                                    inner.b2 + (outer.b2 - inner.b2) * t};
    }
  }
  return kept;
}

}  // namespace

ClipPolygon clipToFrustum(const std::array<glm::vec3, 3>& triangle, const PinholeCamera& camera, float marginPixels) {
  ClipPolygon clipped;
  if (!isFinite(triangle[0]) || !isFinite(triangle[1]) || !isFinite(triangle[2])) {
    return clipped;
  }
  Polygon polygon;
  polygon.count = 3;
  polygon.corners[0] = {triangle[0], 0, 0};
  polygon.corners[1] = {triangle[1], 1, 0};
  polygon.corners[2] = {triangle[2], 0, 1};
  const double zNear = camera.view().zNear;
  const double zFar = camera.view().zFar;
  // The borders of the image, as x and y at z = 1.
  const glm::dvec2 center(camera.centerPixels());
  const glm::dvec2 least = (-center - static_cast<double>(marginPixels)) / static_cast<double>(camera.focalPixels());
  const glm::dvec2 most = (glm::dvec2(camera.width(), camera.height()) - center + static_cast<double>(marginPixels)) /
                          static_cast<double>(camera.focalPixels());
  polygon = clip(polygon, {0, 0, 1}, -zNear);
  polygon = clip(polygon, {0, 0, -1}, zFar);
  polygon = clip(polygon, {1, 0, -least.x}, 0);
  polygon = clip(polygon, {-1, 0, most.x}, 0);
  polygon = clip(polygon, {0, 1, -least.y}, 0);
  polygon = clip(polygon, {0, -1, most.y}, 0);
  // Corners of 1e20 units leave cuts that are off by more than the frustum: keep what comes out within it.
  for (; clipped.count < polygon.count; ++clipped.count) {
    const Corner& corner = polygon.corners[clipped.count];
    const double z = std::clamp(corner.p.z, zNear, zFar);
    clipped.vertices[clipped.count] = {
        {std::clamp(corner.p.x, least.x * z, most.x * z), std::clamp(corner.p.y, least.y * z, most.y * z), z},
        static_cast<float>(corner.b1),
        static_cast<float>(corner.b2)};
  }
  return clipped;
}

}  // namespace ocelli
