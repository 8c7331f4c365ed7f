// An environment map (section 3.5.2.1.2): what is seen from one place in all directions, for rays that begin near it.
#pragma once

#include "oc_core/camera/panorama_camera.h"
#include "oc_core/image/image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class EnvironmentMap {
 public:
  /// From the viewpoint, `height` pixels from pole to pole and twice as many around; `background` where nothing is.
  EnvironmentMap(const glm::vec3& viewpoint, const Mesh& mesh, int height, const glm::vec3& background);

  /// The linear colour in a direction of any length but 0, between the four pixels around it.
  glm::vec3 colorOf(const glm::vec3& direction) const;
  /// Linear; level, as PanoramaCamera has it for a view along -z.
  const Image<glm::vec3>& image() const { return image_; }

 private:
  PanoramaCamera camera_;
  glm::vec3 viewpoint_;
  Image<glm::vec3> image_;
};

}  // namespace ocelli
