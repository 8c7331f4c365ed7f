// What is in a sea of images, in numbers.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/sea/sea_file.h"

namespace ocelli {

struct SeaSummary {
  uint64_t inner = 0;          ///< I-nodes
  uint64_t innerBytes = 0;     ///< of what their codec wrote
  uint64_t residualBytes = 0;  ///< of the others
  uint64_t hiddenBytes = 0;    ///< of the hidden samples of I-nodes
  uint32_t mostAdditions = 0;
  uint64_t rawBytes = 0;  ///< of all images, three bytes a pixel
  uint64_t fileBytes = 0;
  glm::dvec3 lower{0};  ///< of the positions
  glm::dvec3 upper{0};
  double spacing = 0;  ///< the median distance of an image from the nearest other one; 0 of one image

  double ratio() const { return static_cast<double>(rawBytes) / static_cast<double>(fileBytes); }
};

/// The median distance of a position from the nearest other one; 0 of one alone. At least one.
double medianSpacing(const std::vector<glm::dvec3>& positions);

/// Reads the index and the images' bytes once. Throws InputError as SeaFile does.
SeaSummary summaryOf(const SeaFile& sea);

}  // namespace ocelli
