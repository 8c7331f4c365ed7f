#include "oc_core/render/rasterize.h"

#include "oc_core/base/parallel.h"
#include "oc_core/render/draw_parallel.h"
#include "oc_core/render/frustum_clip.h"

namespace ocelli {
namespace {

/// How far beyond the image borders a vertex may project before its triangle is clipped, pixels.
constexpr float kClipMargin = 4096;

RasterVertex rasterVertex(const PinholeCamera& camera, const glm::vec3& cameraPoint) {
  const ImagePoint q = camera.imageFromCamera(cameraPoint);
  return {q.u, q.v, 1 / q.z, 0, 0};
}

bool withinMargin(const PinholeCamera& camera, const RasterVertex& v) {
  return v.u > -kClipMargin && v.v > -kClipMargin && v.u < static_cast<float>(camera.width()) + kClipMargin &&
         v.v < static_cast<float>(camera.height()) + kClipMargin;
}

void drawClipped(VisibilityBuffer& buffer, const PinholeCamera& camera, const Mesh& mesh, uint32_t triangle) {
  const glm::uvec3& t = mesh.triangles[triangle];
  const ClipPolygon polygon =
      clipToFrustum({camera.cameraFromWorld(mesh.positions[t.x]), camera.cameraFromWorld(mesh.positions[t.y]),
                     camera.cameraFromWorld(mesh.positions[t.z])},
                    camera, kClipMargin);
  std::array<RasterVertex, ClipPolygon::kMost> vertices;
  for (size_t i = 0; i < polygon.count; ++i) {
    vertices[i] = rasterVertex(camera, polygon.vertices[i].p);
    vertices[i].b1 = polygon.vertices[i].b1;
    vertices[i].b2 = polygon.vertices[i].b2;
  }
  for (size_t i = 2; i < polygon.count; ++i) {
    buffer.draw(triangle, vertices[0], vertices[i - 1], vertices[i]);
  }
}

}  // namespace

FragmentImage rasterize(const PinholeCamera& camera, const Mesh& mesh) {
  // Project each vertex once, to (u, v, 1/z); 1/z = 0 marks those whose triangles have to be clipped.
  std::vector<glm::vec3> projected(mesh.positions.size(), glm::vec3(0));
  parallelFor(projected.size(), 1 << 13, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::vec3 p = camera.cameraFromWorld(mesh.positions[i]);
      if (p.z >= camera.view().zNear && p.z <= camera.view().zFar) {
        const RasterVertex vertex = rasterVertex(camera, p);
        if (withinMargin(camera, vertex)) {
          projected[i] = {vertex.u, vertex.v, vertex.inverseZ};
        }
      }
    }
  });

  return drawParallel(
      camera.width(), camera.height(), mesh.triangles.size(), [&](VisibilityBuffer& buffer, size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const glm::uvec3& t = mesh.triangles[i];
          const glm::vec3& a = projected[t.x];
          const glm::vec3& b = projected[t.y];
          const glm::vec3& c = projected[t.z];
          if (a.z > 0 && b.z > 0 && c.z > 0) {
            buffer.draw(static_cast<uint32_t>(i), {a.x, a.y, a.z, 0, 0}, {b.x, b.y, b.z, 1, 0}, {c.x, c.y, c.z, 0, 1});
          } else {
            drawClipped(buffer, camera, mesh, static_cast<uint32_t>(i));
          }
        }
      });
}

}  // namespace ocelli
