// Disocclusion error: which samples of the truth a representation lacks, seen from elsewhere (section 3.5.5.7).
//
// The truth is the scene's own mesh, rendered from a viewpoint; the frame is the representation's mesh, rendered from
// the same one at the same size. Both are points in space at each pixel.
//   strict   A truth sample is missing where no frame sample in the 3x3 pixels around it lies within 1.5 pixel
//            footprints of it in space (a footprint is z / focal length at the sample's depth).
//   thick    Strictly missing samples whose eight neighbours are strictly missing too: holes that are three pixels wide
//            at the least, as opposed to seams.
// Ratios are of truth samples, between 0 and 1.
#pragma once

#include <glm/vec4.hpp>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/image.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

/// Samples that are this near to each other in space, in pixel footprints, count as the same.
inline constexpr float kNearFootprints = 1.5f;

/// `kNearFootprints` at the depth of a world point, in world units.
inline float nearReach(const PinholeCamera& camera, const glm::vec3& point) {
  return kNearFootprints * camera.cameraFromWorld(point).z / camera.focalPixels();
}

/// Whether one of the 3x3 samples of `positions` around (x, y) lies within `reach` of `point`.
bool hasSampleNear(const Image<glm::vec4>& positions, int x, int y, const glm::vec3& point, float reach);

struct MissingSamples {
  size_t truth = 0;  ///< truth samples
  size_t strict = 0;
  size_t thick = 0;

  MissingSamples& operator+=(const MissingSamples& other);
  double strictRatio() const { return truth > 0 ? static_cast<double>(strict) / static_cast<double>(truth) : 0; }
  double thickRatio() const { return truth > 0 ? static_cast<double>(thick) / static_cast<double>(truth) : 0; }
};

enum class SampleState : unsigned char { kNoTruth, kPresent, kMissing, kMissingThick };

/// The state of each pixel of `camera`.
Image<SampleState> compareFrames(const PinholeCamera& camera, const Image<glm::vec4>& truth,
                                 const Image<glm::vec4>& frame);

/// World positions seen at each pixel, w = 1 where there is one and 0 where not.
Image<glm::vec4> positionImage(const PinholeCamera& camera, const Mesh& mesh);
/// The same for what `mesh` has been rendered to.
Image<glm::vec4> positionImage(const FragmentImage& fragments, const Mesh& mesh);

MissingSamples countMissing(const Image<SampleState>& states);

}  // namespace ocelli
