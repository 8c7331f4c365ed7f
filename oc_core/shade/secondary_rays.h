// The rays that go on from what mirrors or refracts, one a pixel.
//
// DEVIATION: what mirrors or refracts is not seen in itself or in others of its kind, with whatever stands for the
// scene: the text leaves self-reflections out, too (section 3.5.2.4.1), so no comparison depends on it.
#pragma once

#include <functional>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/image.h"
#include "oc_core/shade/first_surfaces.h"

namespace ocelli {

struct SecondaryRay {
  glm::vec3 origin{0};
  glm::vec3 direction{0};  ///< unit
  uint32_t pixel = 0;      ///< its index in the picture
  uint32_t sender = 0;     ///< the number of the object that it comes from, among those that send rays
};

struct SecondaryRays {
  /// The picture without them: linear colours of what is seen at once.
  Image<glm::vec3> base;
  std::vector<SecondaryRay> rays;  ///< by pixel
};

/// Where a view ray first meets one of the objects.
struct SpecularHit {
  const SpecularObject& object;
  const Fragment& fragment;
  glm::vec3 incoming{0};  ///< unit
  glm::ivec2 pixel{0};
};
/// The ray from there: its pixel and sender need not be set. Called from many threads.
using GoOn = std::function<SecondaryRay(const SpecularHit& hit)>;
/// At each pixel that shows one of the objects.
SecondaryRays raysGoingOn(const FirstSurfaces& surfaces, const PinholeCamera& camera, const GoOn& goOn);

/// At each pixel that shows one of the objects, which mirror: the view ray reflected about the interpolated normal
/// (first order).
SecondaryRays reflectedRays(const FirstSurfaces& surfaces, const PinholeCamera& camera);

/// At each pixel that shows one of the objects, of glass: the ray that leaves it again, after it was refracted where it
/// enters, reflected inside where it cannot leave (four times at most), and refracted where it leaves. A ray that is
/// still inside then goes on as it is. Light that a surface of glass reflects is left out.
///
/// DEVIATION: the text finds where the ray leaves in an image of the back faces; here it is traced through the object,
/// which is exact and the same for all that stands for the scene.
SecondaryRays refractedRays(const FirstSurfaces& surfaces, const PinholeCamera& camera);

}  // namespace ocelli
