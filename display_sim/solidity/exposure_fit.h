// The exposure that makes an observed image comparable with an image.
#pragma once

#include <glm/vec3.hpp>

#include "oc_core/image/png_file.h"

namespace ocelli {

/// The gain for applyTone() with which `light` differs least from `image`: in the mean squared error of sRGB-encoded
/// values, light above 1 counting as white. 1 for an image without light.
double fittedGain(const Image<glm::vec3>& light, const Image<Rgb8>& image);

}  // namespace ocelli
