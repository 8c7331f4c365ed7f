// How similar two images are: SSIM. Images are sRGB-encoded bytes of the same size. Their mean squared error and PSNR
// are in oc_core/image/image_error.h.
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

/// The mean structural similarity, in [-1, 1]; 1 for equal images.
double ssim(const Image<Rgb8>& a, const Image<Rgb8>& b);

}  // namespace ocelli
