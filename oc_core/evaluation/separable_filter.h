// Linear filters that are a product of one along the rows and one along the columns.
#pragma once

#include <vector>

#include "oc_core/image/image.h"

namespace ocelli {

/// Weights at the offsets -radius ... +radius: an odd number of them.
using Kernel = std::vector<float>;

/// Samples of exp(-x^2 / (2 sigma^2)), made to sum to 1.
Kernel gaussianKernel(float sigma, int radius);

/// out(x, y) = sum over i of kernel[i] in(x + i, y), and the same down the columns. Beyond its border an image goes on
/// with its outermost pixels.
Image<float> filterRows(const Image<float>& image, const Kernel& kernel);
Image<float> filterColumns(const Image<float>& image, const Kernel& kernel);

}  // namespace ocelli
