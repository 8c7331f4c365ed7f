#include "oc_core/render/rasterize.h"

#include "oc_core/render/draw_parallel.h"
#include "oc_core/render/pinhole_triangles.h"

namespace ocelli {

FragmentImage rasterize(const ProjectedMesh& projected) {
  const PinholeTriangles triangles(projected);
  return drawParallel(projected.camera().width(), projected.camera().height(), projected.mesh().triangles.size(),
                      [&](VisibilityBuffer& buffer, size_t begin, size_t end) {
                        for (size_t i = begin; i < end; ++i) {
                          const auto triangle = static_cast<uint32_t>(i);
                          triangles.forEachPart(
                              triangle, [&](const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
                                buffer.draw(triangle, a, b, c);
                              });
                        }
                      });
}

FragmentImage rasterize(const PinholeCamera& camera, const Mesh& mesh) {
  return rasterize(ProjectedMesh(camera, mesh));
}

}  // namespace ocelli
