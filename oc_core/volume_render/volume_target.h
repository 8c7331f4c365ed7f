// A volume as something that rays hit: where the opacity of what they have passed reaches a threshold, or at a surface
// inside of it. So whatever casts rays at meshes casts them at volumes.
#pragma once

#include "oc_core/render/ray_target.h"
#include "oc_core/volume_render/volume_renderer.h"

namespace ocelli {

/// Hits have the colour of what the ray has passed, as if it were opaque: the mean of the colours, weighted by how much
/// of each the eye sees. The element is kVolume or kSurface.
class VolumeTarget final : public RayTarget {
 public:
  static constexpr uint32_t kVolume = 0;
  static constexpr uint32_t kSurface = 1;

  /// The threshold is the renderer's depthOpacity. The renderer must outlive this.
  explicit VolumeTarget(const VolumeRenderer& renderer) : renderer_(renderer) {}

  std::optional<Hit> hit(const RayPath& ray) const override;
  void hits(std::span<const RayPath> rays, std::span<std::optional<Hit>> found) const override;
  /// Of the volume's box and of the surfaces.
  Box bounds() const override;

 private:
  const VolumeRenderer& renderer_;
};

}  // namespace ocelli
