// Views from between the images of a sea: the nearest three warped there and blended.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"
#include "oc_core/sea/sea_decoder.h"

namespace ocelli {

/// An image and how much it counts.
struct SeaNeighbor {
  uint32_t image = 0;
  double weight = 0;
};

/// The nearest three images, or fewer where there are no more, the nearest first; weights sum up to 1. At the place of
/// an image it has all the weight; weights fall to 0 towards the distance of the fourth nearest, so that none begins or
/// ends suddenly as one walks on. At least one position.
std::vector<SeaNeighbor> nearestNeighbors(std::span<const glm::dvec3> positions, const glm::dvec3& place);

/// An image that is blended, and where it was taken.
struct BlendedImage {
  const WarpReference* image = nullptr;
  SeaPose pose;
  double weight = 0;
};

/// Each pixel the mean of what those images show that see it, by their weights; filled smoothly where none does. On the
/// calling thread alone.
Image<Rgb8> blendedView(const SeaDecoder& decoder, std::span<const BlendedImage> images, const SeaCamera& target);

}  // namespace ocelli
