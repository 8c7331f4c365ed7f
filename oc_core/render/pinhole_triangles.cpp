#include "oc_core/render/pinhole_triangles.h"

#include "oc_core/base/parallel.h"
#include "oc_core/render/frustum_clip.h"

namespace ocelli {
namespace {

RasterVertex rasterVertex(const PinholeCamera& camera, const glm::vec3& cameraPoint) {
  const ImagePoint q = camera.imageFromCamera(cameraPoint);
  return {q.u, q.v, 1 / q.t, 0, 0};
}

bool withinMargin(const PinholeCamera& camera, const RasterVertex& v) {
  return v.u > -kClipMargin && v.v > -kClipMargin && v.u < static_cast<float>(camera.width()) + kClipMargin &&
         v.v < static_cast<float>(camera.height()) + kClipMargin;
}

}  // namespace

PinholeTriangles::PinholeTriangles(const PinholeCamera& camera, const Mesh& mesh)
    : camera_(camera), mesh_(mesh), projected_(mesh.positions.size()) {
  parallelFor(projected_.size(), 1 << 13, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::vec3 p = camera.cameraFromWorld(mesh.positions[i]);
      if (p.z >= camera.view().zNear && p.z <= camera.view().zFar) {
        const RasterVertex vertex = rasterVertex(camera, p);
        if (withinMargin(camera, vertex)) {
          projected_[i] = vertex;
        }
      }
    }
  });
}

std::vector<RasterVertex> PinholeTriangles::clipped(uint32_t triangle) const {
  const glm::uvec3& t = mesh_.triangles[triangle];
  const ClipPolygon polygon =
      clipToFrustum({camera_.cameraFromWorld(mesh_.positions[t.x]), camera_.cameraFromWorld(mesh_.positions[t.y]),
                     camera_.cameraFromWorld(mesh_.positions[t.z])},
                    camera_, kClipMargin);
  std::vector<RasterVertex> vertices(polygon.count);
  for (size_t i = 0; i < polygon.count; ++i) {
    vertices[i] = rasterVertex(camera_, polygon.vertices[i].p);
    vertices[i].b1 = polygon.vertices[i].b1;
    vertices[i].b2 = polygon.vertices[i].b2;
  }
  return vertices;
}

}  // namespace ocelli
