// How well a dither shows a field (dither_fields.h): how much blocks stray from their light, and what of that the eye
// takes for bands and blotches.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "display_sim/dither_score/dither_fields.h"

namespace ocelli {

inline constexpr int kBlockColumns = 8;
inline constexpr int kBlockRows = 8;
inline constexpr int kBlockSlices = 4;

/// Errors are shares of full light; those of the three channels count alike.
struct DitherScore {
  double meanBlockError = 0;   ///< mean over blocks of |light shown - light wanted|, each the mean of its block
  double worstBlockError = 0;  ///< the largest
  double bias = 0;             ///< of the field as a whole
  /// Root mean square, over columns, of the error of all of a column's voxels together: contours of a ramp.
  double banding = 0;
  /// Power of the error at wavelengths from 16 voxels up to the field's size, in the slices, over that of white noise
  /// of as much power: 1 for white noise, near 0 for blue, above 1 where there are blotches and bands. 0 without error.
  double blotches = 0;
};

/// `shown` as shownLight() gives it.
DitherScore scoreDither(const DitherField& field, const std::vector<glm::vec3>& shown);

/// The means of blocks of a field's lights, in the order of DitherField::index() for a field of blocks.
std::vector<glm::dvec3> blockMeans(const DitherField& field, const std::vector<glm::vec3>& light);

/// The light that every voxel should show.
std::vector<glm::vec3> wantedLight(const DitherField& field);

}  // namespace ocelli
