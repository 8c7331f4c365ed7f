#include "oc_core/render/target_renderer.h"

#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/render/displacement_reach.h"
#include "oc_core/render/rasterize_spans.h"

namespace ocelli {

TargetRenderer::TargetRenderer(const RayTarget& target, Behind behind) : target_(target), behind_(std::move(behind)) {}

FragmentImage TargetRenderer::cast(int width, int height, const std::function<RayPath(const glm::vec2&)>& ray) const {
  const HitImage hits = castRays(width, height, target_, ray);
  FragmentImage fragments(width, height);
  for (size_t i = 0; i < hits.size(); ++i) {
    if (!hits[i]) {
      continue;
    }
    const size_t point = hits_.positions.size();
    OC_CHECK(point < Fragment::kNoTriangle, "hits have numbers of 32 bits");
    const auto number = static_cast<uint32_t>(point);
    hits_.positions.push_back(hits[i]->position);
    hits_.colors.push_back(hits[i]->color);
    hits_.triangles.emplace_back(number);
    fragments[i] = {.t = hits[i]->t, .triangle = number};
  }
  return fragments;
}

FragmentImage TargetRenderer::cast(const CameraRays& rays, const FragmentImage& known) const {
  FragmentImage fragments = cast(rays.width, rays.height, [&](const glm::vec2& pixel) {
    return known(static_cast<int>(pixel.x), static_cast<int>(pixel.y)).covered() ? RayPath{} : rays.ray(pixel);
  });
  takeProjected(fragments, known, rays.project, hits_);
  return fragments;
}

template <Camera C>
FragmentImage TargetRenderer::cast(const C& camera, const FragmentImage& known) const {
  return cast(raysOfCamera(camera), known);
}

template <Camera C>
FragmentImage TargetRenderer::cast(const C& camera) const {
  return cast(camera, FragmentImage(camera.width(), camera.height()));
}

FragmentImage TargetRenderer::draw(const PinholeCamera& camera) const {
  return cast(camera);
}

FragmentImage TargetRenderer::draw(const SpocCamera& camera) const {
  return cast(camera);
}

FragmentImage TargetRenderer::draw(const ReversePinholeCamera& camera) const {
  return cast(camera);
}

FragmentImage TargetRenderer::draw(const GpcCamera& camera) const {
  return cast(camera);
}

FragmentImage TargetRenderer::draw(const DdocCamera& camera, const FragmentImage& seen,
                                   const SubdivisionOptions& /*subdivision*/) const {
  FragmentImage fragments = cast(camera, unreachedPart(camera, seen));
  // What was hit before has a fragment already: only those that differ from it count as displaced.
  for (size_t i = 0; i < fragments.size(); ++i) {
    if (fragments[i].covered() && seen[i].covered() && fragments[i].t == seen[i].t &&
        positionOf(fragments[i], hits_) == positionOf(seen[i], hits_)) {
      fragments[i] = seen[i];
    }
  }
  keepUndisplaced(camera, seen, fragments);
  return fragments;
}

FragmentImage TargetRenderer::drawLines(const PinholeCamera& base, const EpipolarLines& lines) const {
  FragmentImage image = cast(lines.longest(), lines.rowCount(), raysOfLines(base, lines));
  takeDepths(image, base, hits_);
  return image;
}

FragmentImage TargetRenderer::draw(const EpipolarCamera& camera, const FragmentImage& baseImage) const {
  return cast(camera, baseFragments(camera, baseImage));
}

FragmentImage TargetRenderer::draw(const GraphCamera& camera) const {
  return cast(camera);
}

FragmentImage TargetRenderer::draw(const CurvedRayCamera& camera) const {
  return cast(camera);
}

std::optional<FragmentImage> TargetRenderer::drawAlong(const CameraRays& rays) const {
  return cast(rays, FragmentImage(rays.width, rays.height));
}

std::optional<std::vector<FragmentImage>> TargetRenderer::drawLayers(const PinholeCamera& camera, int layers) const {
  std::vector<FragmentImage> images{cast(camera)};
  while (behind_ && static_cast<int>(images.size()) < layers) {
    const FragmentImage& before = images.back();
    FragmentImage image = cast(camera.width(), camera.height(), [&](const glm::vec2& pixel) {
      const Fragment& fragment = before(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
      return fragment.covered()
                 ? behind_(camera.rayPath(pixel), {.t = fragment.t, .position = positionOf(fragment, hits_)})
                 : RayPath{};
    });
    takeProjected(
        image, FragmentImage(camera.width(), camera.height()),
        [&](const glm::vec3& point) { return camera.project(point); }, hits_);
    images.push_back(std::move(image));
  }
  return images;
}

}  // namespace ocelli
