// What a representation shows that is not there: the counterpart of the missing samples of coverage.h.
//
//   false skin    A frame sample is false where no point of the scene's surface, seen or hidden, lies within 1.5 pixel
//                 footprints of it in space: the mesh joins what is apart. A surface of the scene that shows only
//                 because something before it is missing is not false, and neither is a rim that stands out of a
//                 silhouette by up to a pixel.
//   wrong front   A strictly missing truth sample has a wrong front where the frame's sample at its pixel is nearer
//                 than it by more than 1.5 footprints along the view direction: a false surface hides it.
#pragma once

#include <cstdint>
#include <functional>

#include "oc_core/ocri/coverage.h"
#include "oc_core/render/raycast.h"

namespace ocelli {

/// Whether a point of the scene's surface lies within `reach` of a point. Safe to call from many threads.
using SurfaceSearch = std::function<bool(const glm::vec3& point, float reach)>;
/// The scene must outlive it.
SurfaceSearch searchOf(const RayScene& scene);

/// 1 at each pixel of `frame` whose sample is false. `truth` shows the scene, and saves most of the searches.
Image<uint8_t> falseSkins(const PinholeCamera& camera, const Image<glm::vec4>& truth, const Image<glm::vec4>& frame,
                          const SurfaceSearch& hasSurfaceNear);
/// The same of a mesh.
Image<uint8_t> falseSkins(const PinholeCamera& camera, const Image<glm::vec4>& truth, const Image<glm::vec4>& frame,
                          const RayScene& scene);

/// 1 at each pixel of `truth` whose sample has a wrong front. `states` is compareFrames() of the two.
Image<uint8_t> wrongFronts(const PinholeCamera& camera, const Image<glm::vec4>& truth, const Image<glm::vec4>& frame,
                           const Image<SampleState>& states);

}  // namespace ocelli
