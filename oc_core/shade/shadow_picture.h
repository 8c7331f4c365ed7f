// What a picture of a scene under an area light is made of: the surfaces that its pixels show, as receivers of light.
#pragma once

#include <memory>
#include <vector>

#include "oc_core/render/raycast.h"
#include "oc_core/shade/shaded_scene.h"
#include "oc_core/soft_shadows/area_visibility.h"

namespace ocelli {

struct ShadowPixel {
  uint32_t pixel = 0;       ///< its index in the picture
  bool isMeasured = false;  ///< whether its object has the role `receive`, and the light shines at it
  glm::vec3 color{0};       ///< of the surface, linear
  float cosines = 0;        ///< of the surface against the light's centre, and of the light against the surface
};

struct ShadowPixels {
  Image<glm::vec3> base;                  ///< of pixels without a receiver: background, the light itself
  std::vector<ShadowPixel> pixels;        ///< neighbours follow each other, square by square of the picture
  std::vector<ShadowReceiver> receivers;  ///< of each
};

class ShadowSurfaces {
 public:
  /// The scene has a light, and must outlive this.
  explicit ShadowSurfaces(const ShadedScene& scene);
  /// It stays where it is: rays refer to its mesh.
  ShadowSurfaces(const ShadowSurfaces&) = delete;
  ShadowSurfaces& operator=(const ShadowSurfaces&) = delete;

  ShadowPixels seenBy(const PinholeCamera& camera) const;

 private:
  const ShadedScene& scene_;
  LightFrame frame_;
  Mesh mesh_;
  std::vector<glm::vec3> normals_;
  std::unique_ptr<RayScene> rays_;
};

/// Lit by some even light, and by the area light as far as each pixel sees it.
Image<glm::vec3> litPicture(const ShadowPixels& pixels, const std::vector<float>& visibility);

}  // namespace ocelli
