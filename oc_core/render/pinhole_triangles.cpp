#include "oc_core/render/pinhole_triangles.h"

namespace ocelli {
namespace {

RasterVertex rasterVertex(const PinholeCamera& camera, const glm::vec3& cameraPoint) {
  const ImagePoint q = camera.imageFromCamera(cameraPoint);
  return {q.u, q.v, 1 / q.t, 0, 0};
}

}  // namespace

std::vector<RasterVertex> PinholeTriangles::clipped(uint32_t triangle) const {
  const PinholeCamera& camera = projected_.camera();
  const Mesh& mesh = projected_.mesh();
  const glm::uvec3& t = mesh.triangles[triangle];
  const ClipPolygon polygon =
      clipToFrustum({camera.cameraFromWorld(mesh.positions[t.x]), camera.cameraFromWorld(mesh.positions[t.y]),
                     camera.cameraFromWorld(mesh.positions[t.z])},
                    camera, kClipMargin);
  std::vector<RasterVertex> vertices(polygon.count);
  for (size_t i = 0; i < polygon.count; ++i) {
    vertices[i] = rasterVertex(camera, polygon.vertices[i].p);
    vertices[i].b1 = polygon.vertices[i].b1;
    vertices[i].b2 = polygon.vertices[i].b2;
  }
  return vertices;
}

}  // namespace ocelli
