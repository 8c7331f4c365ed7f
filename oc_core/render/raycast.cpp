#include "oc_core/render/raycast.h"

#include <cmath>

#include "oc_core/render/pixel_tiles.h"

namespace ocelli {

std::optional<Hit> RayScene::hit(const RayPath& ray) const {
  std::optional<Hit> result;
  hits(std::span(&ray, 1), std::span(&result, 1));
  return result;
}

void RayScene::hits(std::span<const RayPath> rays, std::span<std::optional<Hit>> found) const {
  std::vector<Fragment> fragments(rays.size());
  intersect(rays, fragments);
  for (size_t i = 0; i < rays.size(); ++i) {
    const Fragment& f = fragments[i];
    found[i] =
        f.covered() ? std::optional(Hit{f.t, positionOf(f, mesh()), colorOf(f, mesh()), f.triangle}) : std::nullopt;
  }
}

FragmentImage castRays(int width, int height, const RayScene& scene,
                       const std::function<RayPath(const glm::vec2&)>& rayPath) {
  return castTiles<Fragment>(width, height, rayPath, [&](std::span<const RayPath> rays, std::span<Fragment> fragments) {
    scene.intersect(rays, fragments);
  });
}

namespace {

/// Or so near to it that rounding may have moved it. Of a point that an image shows several times, as where the frusta
/// of a graph camera overlap, project() gives one: elsewhere the parameter of the ray stands.
bool isInPixel(const ImagePoint& q, size_t pixel, int width) {
  constexpr float kReach = 0.75f;  // from its centre: half a pixel, and what rays and projections differ by
  const auto across = static_cast<size_t>(width);
  return std::abs(q.u - (static_cast<float>(pixel % across) + 0.5f)) < kReach &&
         std::abs(q.v - (static_cast<float>(pixel / across) + 0.5f)) < kReach;
}

}  // namespace

void takeProjected(FragmentImage& fragments, const FragmentImage& known,
                   const std::function<std::optional<ImagePoint>(const glm::vec3&)>& project, const Mesh& mesh) {
  parallelFor(fragments.size(), 1 << 12, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (known[i].covered()) {
        fragments[i] = known[i];
      } else if (fragments[i].covered() && project) {
        const std::optional<ImagePoint> q = project(positionOf(fragments[i], mesh));
        if (!q) {
          fragments[i] = {};
        } else if (isInPixel(*q, i, fragments.width())) {
          fragments[i].t = q->t;
        }
      }
    }
  });
}

FragmentImage raycast(const CameraRays& rays, const Mesh& mesh, const RayScene& scene, const FragmentImage& known) {
  FragmentImage fragments = castRays(rays.width, rays.height, scene, [&](const glm::vec2& pixel) {
    return known(static_cast<int>(pixel.x), static_cast<int>(pixel.y)).covered() ? RayPath{} : rays.ray(pixel);
  });
  takeProjected(fragments, known, rays.project, mesh);
  return fragments;
}

}  // namespace ocelli
