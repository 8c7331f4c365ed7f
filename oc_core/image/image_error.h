// How much two images differ, judged as signals: mean squared error and PSNR. Images are sRGB-encoded bytes of the same
// size.
#pragma once

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// Over all pixels and channels, of values from 0 to 1. OC_CHECKs that both images have pixels, and the same size.
double meanSquaredError(const Image<Rgb8>& a, const Image<Rgb8>& b);

/// 10 log10(1 / error), dB; infinite where the error is 0.
double psnrDecibels(double meanSquaredError);

}  // namespace ocelli
