#include "oc_core/camera/distortion_map.h"

#include <glm/geometric.hpp>

namespace ocelli {

float DistortionMap::longestDisplacement() const {
  float longest = 0;  // squared
  for (const DistortionSample& sample : samples_) {
    longest = std::max(longest, glm::dot(sample.displacement, sample.displacement));
  }
  return std::sqrt(longest);
}

}  // namespace ocelli
