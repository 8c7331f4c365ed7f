#include "oc_core/render/scene_renderer.h"

#include "oc_core/render/displacement_reach.h"
#include "oc_core/render/rasterize_spans.h"

namespace ocelli {

FragmentImage RayRenderer::draw(const PinholeCamera& camera) const {
  return raycast(camera, mesh_, rays_);
}

FragmentImage RayRenderer::draw(const SpocCamera& camera) const {
  return raycast(camera, mesh_, rays_);
}

FragmentImage RayRenderer::draw(const ReversePinholeCamera& camera) const {
  return raycast(camera, mesh_, rays_);
}

FragmentImage RayRenderer::draw(const GpcCamera& camera) const {
  return raycast(camera, mesh_, rays_);
}

FragmentImage RayRenderer::draw(const DdocCamera& camera, const FragmentImage& seen,
                                const SubdivisionOptions& /*subdivision*/) const {
  return raycast(camera, seen, mesh_, rays_);
}

FragmentImage RayRenderer::drawLines(const PinholeCamera& base, const EpipolarLines& lines) const {
  FragmentImage image = castRays(lines.longest(), lines.rowCount(), rays_, [&](const glm::vec2& pixel) {
    const int row = static_cast<int>(pixel.y);
    const double position = static_cast<double>(pixel.x);
    return pixel.x < static_cast<float>(lines.length(row)) && lines.has(row, position)
               ? base.rayPath(glm::vec2(lines.imagePoint({static_cast<double>(pixel.y), position})))
               : RayPath{};
  });
  parallelFor(image.size(), 1 << 12, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      image[i].t = image[i].covered() ? base.cameraFromWorld(positionOf(image[i], mesh_)).z : 0;
    }
  });
  return image;
}

FragmentImage RayRenderer::draw(const EpipolarCamera& camera, const FragmentImage& baseImage) const {
  return raycast(camera, mesh_, rays_, baseFragments(camera, baseImage));
}

FragmentImage RayRenderer::draw(const GraphCamera& camera) const {
  return raycast(camera, mesh_, rays_);
}

FragmentImage RayRenderer::draw(const CurvedRayCamera& camera) const {
  return raycast(camera, mesh_, rays_);
}

}  // namespace ocelli
