#include "oc_core/render/raycast.h"

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

}  // namespace ocelli
