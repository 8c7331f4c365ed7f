#include "oc_core/render/rasterize.h"

#include "oc_core/render/draw_parallel.h"
#include "oc_core/render/pinhole_triangles.h"

namespace ocelli {

FragmentImage rasterize(const PinholeCamera& camera, const Mesh& mesh) {
  const PinholeTriangles triangles(camera, mesh);
  return drawParallel(
      camera.width(), camera.height(), mesh.triangles.size(), [&](VisibilityBuffer& buffer, size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const auto triangle = static_cast<uint32_t>(i);
          triangles.forEachPart(triangle, [&](const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
            buffer.draw(triangle, a, b, c);
          });
        }
      });
}

}  // namespace ocelli
