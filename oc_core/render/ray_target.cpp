#include "oc_core/render/ray_target.h"

#include "oc_core/render/pixel_tiles.h"

namespace ocelli {

void RayTarget::hits(std::span<const RayPath> rays, std::span<std::optional<Hit>> found) const {
  OC_CHECK(rays.size() == found.size(), "one hit a ray");
  for (size_t i = 0; i < rays.size(); ++i) {
    found[i] = hit(rays[i]);
  }
}

HitImage castRays(int width, int height, const RayTarget& target,
                  const std::function<RayPath(const glm::vec2&)>& rayPath) {
  return castTiles<std::optional<Hit>>(
      width, height, rayPath,
      [&](std::span<const RayPath> rays, std::span<std::optional<Hit>> found) { target.hits(rays, found); });
}

}  // namespace ocelli
