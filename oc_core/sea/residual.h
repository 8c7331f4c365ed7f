// Residual images: what an image of a sea has beyond what was predicted of it, as an image that any codec of colours
// takes.
//
// A byte holds 128 plus half of the difference: differences reach from -255 to 255, and none is cut off. What that
// loses, a step of one, is far below what is lost by coding.
#pragma once

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

Image<Rgb8> residualOf(const Image<Rgb8>& image, const Image<Rgb8>& predicted);
/// What residualOf() was made of, but for its rounding; in place of `predicted`.
void addResidual(Image<Rgb8>& predicted, const Image<Rgb8>& residual);

/// The energy of a residual as the text has it: the mean absolute difference of luminance, in steps of 8-bit values.
double residualEnergy(const Image<Rgb8>& image, const Image<Rgb8>& predicted);

}  // namespace ocelli
