// What rays can be cast at: a mesh (RayScene of raycast.h), and whatever else answers where a ray first hits it.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "oc_core/camera/camera.h"
#include "oc_core/image/image.h"
#include "oc_core/scene/box.h"

namespace ocelli {

/// Where a ray first meets something.
struct Hit {
  float t = 0;            ///< the parameter of the ray there
  glm::vec3 position{0};  ///< in the world
  glm::vec3 color{0};     ///< linear RGB
  uint32_t element = 0;   ///< what was hit, as the target numbers its parts: of a mesh, the triangle
};

class RayTarget {
 public:
  virtual ~RayTarget() = default;

  /// Nothing where the ray meets nothing, or has coordinates that are not finite. Safe to call from many threads.
  virtual std::optional<Hit> hit(const RayPath& ray) const = 0;
  /// The same for each of many rays, one entry of `found` a ray; it may be faster where neighbours run alike.
  virtual void hits(std::span<const RayPath> rays, std::span<std::optional<Hit>> found) const;
  /// Around all of it, in the world; empty where there is nothing to hit.
  virtual Box bounds() const = 0;
};

using HitImage = Image<std::optional<Hit>>;

/// The first hit along the ray of each pixel centre. On all threads.
HitImage castRays(int width, int height, const RayTarget& target,
                  const std::function<RayPath(const glm::vec2& pixel)>& rayPath);

template <Camera C>
HitImage castRays(const C& camera, const RayTarget& target) {
  return castRays(camera.width(), camera.height(), target,
                  [&](const glm::vec2& pixel) { return camera.rayPath(pixel); });
}

}  // namespace ocelli
