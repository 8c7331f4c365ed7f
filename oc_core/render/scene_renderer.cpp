#include "oc_core/render/scene_renderer.h"

#include <span>

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

namespace {

/// The columns of an epipolar camera whose rays are those of base pixels that see nothing: 1.
Image<uint8_t> emptyColumns(const EpipolarCamera& camera, const FragmentImage& baseImage) {
  Image<uint8_t> empty(camera.width(), camera.height(), uint8_t{0});
  for (int row = 0; row < camera.height(); ++row) {
    const std::span<const EpipolarCamera::Disocclusion> disocclusions = camera.disocclusions(row);
    size_t edge = 0;
    int shift = 0;
    for (int j = 0; j < camera.lines().length(row); ++j) {
      while (edge < disocclusions.size() && disocclusions[edge].position <= j) {
        shift = disocclusions[edge++].shift;
      }
      empty(j + shift, row) = baseImage(j, row).covered() ? 0 : 1;
    }
  }
  return empty;
}

}  // namespace

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
  const FragmentImage known = baseFragments(camera, baseImage);
  // Where the base sees nothing, its ray meets nothing.
  const Image<uint8_t> empty = emptyColumns(camera, baseImage);
  FragmentImage fragments = castRays(camera.width(), camera.height(), rays_, [&](const glm::vec2& pixel) {
    const glm::ivec2 at(pixel);
    return known(at.x, at.y).covered() || empty(at.x, at.y) != 0 ? RayPath{} : camera.rayPath(pixel);
  });
  takeProjected(
      fragments, known, [&](const glm::vec3& point) { return camera.project(point); }, mesh_);
  return fragments;
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
