// How far apart the samples of a reference image lie.
#pragma once

#include "oc_core/ocri/reference_image.h"

namespace ocelli {

/// Pixels of the pinhole from a sample to the next: in tiles what they say, and in the regions of a general pinhole
/// (ReferenceImage::layout) and around them the geometric mean of both directions. Empty for images without these.
Image<float> sampleSpacings(const ReferenceImage& image);

}  // namespace ocelli
