// Cubic convolution: how much each of four neighbours counts for a place between the second and the third one.
#pragma once

#include <array>

namespace ocelli {

/// Catmull and Rom's spline. `fraction` in [0, 1) is how far the place is from the second neighbour; the sum is 1.
inline std::array<float, 4> cubicWeights(float fraction) {
  const float f = fraction;
  return {((-0.5f * f + 1.0f) * f - 0.5f) * f, (1.5f * f - 2.5f) * f * f + 1.0f, ((-1.5f * f + 2.0f) * f + 0.5f) * f,
          (0.5f * f - 0.5f) * f * f};
}

}  // namespace ocelli
