// Disocclusion error: which samples of the truth a representation lacks, seen from elsewhere (section 3.5.5.7).
//
// The truth is the scene's own mesh, rendered from a viewpoint; the frame is the representation's mesh, rendered from
// the same one at the same size. Both are points in space at each pixel.
//   strict   A truth sample is missing where no frame sample in the 3x3 pixels around it lies within 1.5 pixel
//   footprints of
//            it in space (a footprint is z / focal length at the sample's depth).
//   thick    Strictly missing samples whose eight neighbours are strictly missing too: holes that are three pixels wide
//   at
//            the least, as opposed to seams.
// Ratios are of truth samples, between 0 and 1.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "oc_core/base/image.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

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

MissingSamples countMissing(const Image<SampleState>& states);

/// The cube of viewpoints of section 3.5.5.7, around the reference eye and aligned with its view.
struct ViewCell {
  float sideRadii = 1.6f;  ///< 8 in at the reference display

  std::vector<View> edgeViews(const View& reference) const;  ///< 12 edge midpoints, then 8 corners
  /// `count` viewpoints inside, uniform, from a seed.
  std::vector<View> interiorViews(const View& reference, int count, unsigned seed) const;
};

}  // namespace ocelli
