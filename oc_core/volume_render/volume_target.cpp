#include "oc_core/volume_render/volume_target.h"

#include <vector>

namespace ocelli {

std::optional<Hit> VolumeTarget::hit(const RayPath& ray) const {
  std::optional<Hit> found;
  hits(std::span(&ray, 1), std::span(&found, 1));
  return found;
}

void VolumeTarget::hits(std::span<const RayPath> rays, std::span<std::optional<Hit>> found) const {
  OC_CHECK(rays.size() == found.size(), "one hit a ray");
  std::vector<VolumePixel> pixels(rays.size());
  renderer_.firstHits(rays, pixels);
  for (size_t i = 0; i < rays.size(); ++i) {
    const VolumePixel& pixel = pixels[i];
    const float t = pixel.opaqueT();
    if (t == VolumePixel::kNowhere) {
      found[i] = std::nullopt;
      continue;
    }
    found[i] = Hit{t, rays[i].pointAt(rays[i].positionAt(t)), glm::vec3(pixel.color) / pixel.color.w,
                   pixel.t <= pixel.surfaceT ? kVolume : kSurface};
  }
}

Box VolumeTarget::bounds() const {
  Box box = renderer_.scene().bounds();
  for (const glm::vec3& position : renderer_.scene().surfaces.positions) {
    box.add(position);
  }
  return box;
}

}  // namespace ocelli
