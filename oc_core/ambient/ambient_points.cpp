#include "oc_core/ambient/ambient_points.h"

#include <glm/geometric.hpp>

namespace ocelli {

std::vector<AmbientPoint> ambientPoints(const PinholeCamera& camera, const FragmentImage& seen, const Mesh& mesh,
                                        const std::function<bool(uint32_t triangle)>& receives) {
  std::vector<AmbientPoint> points;
  for (size_t i = 0; i < seen.size(); ++i) {
    const Fragment& fragment = seen[i];
    if (!fragment.covered() || (receives && !receives(fragment.triangle))) {
      continue;
    }
    const glm::uvec3& t = mesh.triangles[fragment.triangle];
    const glm::dvec3 a(mesh.positions[t.x]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a);
    const double length = glm::length(normal);
    if (!(length > 0)) {
      continue;
    }
    AmbientPoint point;
    point.position = positionOf(fragment, mesh);
    const bool faces = glm::dot(normal, glm::dvec3(camera.eye()) - a) >= 0;
    point.normal = glm::vec3(normal / (faces ? length : -length));
    point.footprint = camera.cameraFromWorld(point.position).z / camera.focalPixels();
    point.pixel = static_cast<uint32_t>(i);
    point.triangle = fragment.triangle;
    points.push_back(point);
  }
  return points;
}

}  // namespace ocelli
