// What the construction of a DDOC learned about its bands, for the image of an eye that has moved on: where "do no
// harm" shrank them. A silhouette is found again by where it was in space, whatever the size of the next image.
//
// Between two images the bands follow what the last one showed: one that did harm shrinks, and one that did none grows
// a little, until it is as wide as the parallax asks for.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/ocri/distortion_splats.h"

namespace ocelli {

class BandMemory {
 public:
  /// How much of its hidden band each splat keeps, in (0, 1]: that of the silhouette that is remembered nearest to it,
  /// about as near to the eye, within a few pixels; and for how many there is one.
  struct Recalled {
    std::vector<float> kept;
    size_t known = 0;
  };
  Recalled recall(const PinholeCamera& camera, const std::vector<DistortionSplat>& splats) const;

  /// From where the last image was seen; nothing before the first.
  const std::optional<glm::vec3>& eye() const { return eye_; }

  /// Of each splat, as `camera` has it, what it keeps from now on.
  void remember(const PinholeCamera& camera, const std::vector<DistortionSplat>& splats,
                const std::vector<float>& kept);

 private:
  struct Band {
    glm::vec3 occluder{0};  ///< a point of the silhouette, world coordinates
    float kept = 1;
  };
  std::optional<glm::vec3> eye_;
  std::vector<Band> bands_;
};

}  // namespace ocelli
