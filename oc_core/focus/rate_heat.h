// Sampling rates in false colours over a picture.
#pragma once

#include <glm/vec3.hpp>

#include "oc_core/image/png_file.h"

namespace ocelli {

/// The ends of a scale of equal factors.
struct RateRange {
  double least = 1;
  double greatest = 1;
  bool operator==(const RateRange&) const = default;
};

/// sRGB. The colours are those of color_scale.h, from pale yellow for the least rate to dark blue for the greatest one;
/// rates beyond are as the ends. The picture, of the same size, shows through by its brightness; it may be empty.
Image<Rgb8> rateHeat(const Image<float>& rates, const RateRange& range, const Image<Rgb8>& picture);
/// The colour of one rate, without a picture.
Rgb8 rateColor(double rate, const RateRange& range);

}  // namespace ocelli
