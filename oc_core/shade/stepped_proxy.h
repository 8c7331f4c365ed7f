// What rays see of a reference image that they walk through by steps along their projections (section 3.5.2.2), with
// silhouettes that fade (section 3.5.2.4.1): the text's way, for users.
#pragma once

#include "oc_core/depth_rays/stepped_image.h"
#include "oc_core/image/image.h"
#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

/// The colour between the samples of the four pixels around a place; 0 where there are none.
glm::vec3 colorAround(const ReferenceImage& image, const glm::dvec2& place);

/// What a ray meets by steps.
struct SteppedHit {
  glm::vec3 color{0};   ///< linear
  float distance = 0;   ///< from the ray's origin
  glm::dvec2 place{0};  ///< in the image, pixels
  float opacity = 1;    ///< less at silhouettes: what is behind shows through
};

class SteppedTarget {
 public:
  /// Throws InputError where the choice is a union, has layers, or has no projection: such rays cannot walk in one
  /// image. Builds the camera once more for its projection.
  SteppedTarget(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh, ReferenceImages images,
                double finePixels, const Progress& progress);

  /// Along `origin + share * step` for shares up to 1.
  std::optional<SteppedHit> hit(const glm::vec3& origin, const glm::vec3& step, RayCost& cost) const;

 private:
  ReferenceImages images_;
  std::vector<CameraMap> maps_;
  std::optional<SteppedImage> stepped_;
};

}  // namespace ocelli
