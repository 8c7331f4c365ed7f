#include "oc_core/render/scene_renderer.h"

#include "oc_core/render/displacement_reach.h"
#include "oc_core/render/rasterize_spans.h"

namespace ocelli {

std::function<RayPath(const glm::vec2&)> raysOfLines(const PinholeCamera& base, const EpipolarLines& lines) {
  return [&](const glm::vec2& pixel) {
    const int row = static_cast<int>(pixel.y);
    const double position = static_cast<double>(pixel.x);
    return pixel.x < static_cast<float>(lines.length(row)) && lines.has(row, position)
               ? base.rayPath(glm::vec2(lines.imagePoint({static_cast<double>(pixel.y), position})))
               : RayPath{};
  };
}

void takeDepths(FragmentImage& fragments, const PinholeCamera& camera, const Mesh& mesh) {
  parallelFor(fragments.size(), 1 << 12, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      Fragment& fragment = fragments[i];
      fragment.t = fragment.covered() ? camera.cameraFromWorld(positionOf(fragment, mesh)).z : 0;
    }
  });
}

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
  FragmentImage image = castRays(lines.longest(), lines.rowCount(), rays_, raysOfLines(base, lines));
  takeDepths(image, base, mesh_);
  return image;
}

FragmentImage RayRenderer::draw(const EpipolarCamera& camera, const FragmentImage& baseImage) const {
  return raycast(camera, mesh_, rays_, baseFragments(camera, baseImage));
}

std::optional<FragmentImage> RayRenderer::drawAlong(const CameraRays& rays) const {
  return raycast(rays, mesh_, rays_, FragmentImage(rays.width, rays.height));
}

FragmentImage RayRenderer::draw(const GraphCamera& camera) const {
  return raycast(camera, mesh_, rays_);
}

FragmentImage RayRenderer::draw(const CurvedRayCamera& camera) const {
  return raycast(camera, mesh_, rays_);
}

}  // namespace ocelli
