#include "oc_core/render/frustum_clip.h"

namespace ocelli {
namespace {

/// Sutherland-Hodgman against one plane: keeps where dot(normal, p) + offset >= 0.
ClipPolygon clip(const ClipPolygon& polygon, const glm::vec3& normal, float offset) {
  ClipPolygon kept;
  for (size_t i = 0; i < polygon.count; ++i) {
    const ClipVertex& a = polygon.vertices[i];
    const ClipVertex& b = polygon.vertices[(i + 1) % polygon.count];
    const float da = glm::dot(normal, a.p) + offset;
    const float db = glm::dot(normal, b.p) + offset;
    if (da >= 0 && kept.count < ClipPolygon::kMost) {
      kept.vertices[kept.count++] = a;
    }
    if ((da >= 0) != (db >= 0) && kept.count < ClipPolygon::kMost) {
      const float t = da / (da - db);
      kept.vertices[kept.count++] = {a.p + (b.p - a.p) * t, a.b1 + (b.b1 - a.b1) * t, a.b2 + (b.b2 - a.b2) * t};
    }
  }
  return kept;
}

}  // namespace

ClipPolygon clipToFrustum(const std::array<glm::vec3, 3>& triangle, const PinholeCamera& camera, float marginPixels) {
  ClipPolygon polygon;
  polygon.count = 3;
  polygon.vertices[0] = {triangle[0], 0, 0};
  polygon.vertices[1] = {triangle[1], 1, 0};
  polygon.vertices[2] = {triangle[2], 0, 1};
  const float right = (static_cast<float>(camera.width()) / 2 + marginPixels) / camera.focalPixels();
  const float down = (static_cast<float>(camera.height()) / 2 + marginPixels) / camera.focalPixels();
  polygon = clip(polygon, {0, 0, 1}, -camera.view().zNear);
  polygon = clip(polygon, {0, 0, -1}, camera.view().zFar);
  polygon = clip(polygon, {1, 0, right}, 0);
  polygon = clip(polygon, {-1, 0, right}, 0);
  polygon = clip(polygon, {0, 1, down}, 0);
  polygon = clip(polygon, {0, -1, down}, 0);
  return polygon;
}

}  // namespace ocelli
