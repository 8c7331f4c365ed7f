#include "oc_core/camera/distortion_map.h"

#include <glm/geometric.hpp>

namespace ocelli {

float DistortionMap::longestDisplacement() const {
  float longest = 0;
  for (const DistortionSample& sample : samples_) {
    longest = std::max(longest, glm::length(sample.displacement));
  }
  return longest;
}

}  // namespace ocelli
