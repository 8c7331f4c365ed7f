// Bounds on the displacements of a distortion map over rectangles of the image: a pyramid of least and greatest values.
// What a conservative footprint of a triangle (section 6.1.3.1) and a ray that is straight where nothing bends it need.
#pragma once

#include <vector>

#include "oc_core/camera/distorted_pinhole.h"
#include "oc_core/camera/distortion_map.h"

namespace ocelli {

class DisplacementBounds {
 public:
  /// What the samples of a region lie between.
  struct Range {
    ImageBox displacement;  ///< in full, pixels; 0 is always in it
    float minInverseNear = 0;
    float greatestInverseNear = 0;
    float minInverseFar = 0;
    float greatestInverseFar = 0;
    /// 1/z outside of which no sample of the region changes its displacement. Empty (upper < lower) where none has any.
    float rampLower = 1;
    float rampUpper = 0;

    /// The longest displacement, pixels.
    float longest() const { return glm::length(glm::max(-displacement.lower, displacement.upper)); }
    /// The displacements that Equation 3.3 gives within a range of 1/z.
    ImageBox at(float minInverseZ, float greatestInverseZ) const;
  };

  DisplacementBounds() = default;
  explicit DisplacementBounds(const DistortionMap& map);

  /// Of every sample that a lookup in `undistorted` (pixels) may take.
  Range over(const ImageBox& undistorted) const;

 private:
  std::vector<Image<Range>> levels_;  ///< each cell of a level joins 2x2 of the one before
};

}  // namespace ocelli
