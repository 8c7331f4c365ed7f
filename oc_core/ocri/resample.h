// Conventional pictures from reference images (section 5.2.1.4): what a pinhole would see, of what an image holds.
//
// From the image's own eye the rays are the same ones: each pixel looks up where its ray meets the image, whatever the
// view direction and the field of view, as exactly as the image is sampled. From elsewhere, and of images that displace
// a pinhole's, its samples are moved by their depth (3-D warping): joined to surfaces as in image_mesh.h, so that what
// comes nearer does not fall apart. What was hidden from the image is then missing: holes.
#pragma once

#include "oc_core/ocri/reference_image.h"

namespace ocelli {

struct ResampledView {
  Image<glm::vec3> color;  ///< linear; black where nothing is known, and where nothing is seen
  Image<float> t;          ///< z of what was warped; 0 where there is nothing, or rays were looked up
  Image<uint8_t> hole;     ///< 1 where nothing is known
  bool isWarped = false;   ///< by depth; otherwise by looking up rays

  /// Share of the pixels.
  double holes() const;
  /// Of the pixels that are no holes, the share where the image has fewer samples than this view has pixels, in one
  /// direction at least: detail is missing there. Nothing is said of images that displace a pinhole's: 0.
  double coarse = 0;
  /// Samples for each pixel where there are fewest, in the direction that has fewest; 1 where nothing is said.
  double leastRate = 1;
};

/// At least one image. Pixels that stand for several samples are their average, of as many as there are along either
/// axis, up to 16.
ResampledView resample(const ReferenceImages& images, const PinholeCamera& view);

}  // namespace ocelli
