// How much two images differ, judged as signals: mean squared error, PSNR and SSIM. Images are sRGB-encoded bytes
// of the same size.
//
// SSIM follows Wang, Bovik, Sheikh and Simoncelli (2004): Gaussian windows of 11x11 with sigma 1.5, K1 = 0.01,
// K2 = 0.03, L = 255, on luma (0.299 R + 0.587 G + 0.114 B of the encoded values).
//
// DEVIATION: windows that reach beyond the image are filled with its outermost pixels, where the original leaves them
// out: so every pixel counts, and images smaller than a window have a value too.
#pragma once

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// Over all pixels and channels, of values from 0 to 1. Both images have pixels.
double meanSquaredError(const Image<Rgb8>& a, const Image<Rgb8>& b);

/// 10 log10(1 / error), dB; infinite where the error is 0.
double psnrDecibels(double meanSquaredError);

/// The mean structural similarity, in [-1, 1]; 1 for equal images.
double ssim(const Image<Rgb8>& a, const Image<Rgb8>& b);

}  // namespace ocelli
