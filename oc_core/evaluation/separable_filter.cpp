#include "oc_core/evaluation/separable_filter.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kRowsAtOnce = 16;

int radiusOf(const Kernel& kernel) {
  OC_CHECK(kernel.size() % 2 == 1, "a kernel has a middle");
  return static_cast<int>(kernel.size() / 2);
}

void addScaled(float* out, const float* in, float weight, int count) {
  for (int x = 0; x < count; ++x) {
    out[x] += weight * in[x];
  }
}

}  // namespace

Kernel gaussianKernel(float sigma, int radius) {
  Kernel kernel;
  float sum = 0;
  for (int i = -radius; i <= radius; ++i) {
    kernel.push_back(std::exp(-static_cast<float>(i * i) / (2 * sigma * sigma)));
    sum += kernel.back();
  }
  for (float& weight : kernel) {
    weight /= sum;
  }
  return kernel;
}

Image<float> filterRows(const Image<float>& image, const Kernel& kernel) {
  const int radius = radiusOf(kernel);
  const int width = image.width();
  Image<float> filtered(width, image.height());
  parallelFor(static_cast<size_t>(image.height()), kRowsAtOnce, [&](size_t begin, size_t end) {
    std::vector<float> padded(static_cast<size_t>(width) + kernel.size() - 1);
    for (size_t row = begin; row < end; ++row) {
      const float* in = &image(0, static_cast<int>(row));
      std::fill_n(padded.begin(), radius, in[0]);
      std::copy_n(in, width, padded.begin() + radius);
      std::fill_n(padded.begin() + radius + width, radius, in[width - 1]);
      for (size_t i = 0; i < kernel.size(); ++i) {
        addScaled(&filtered(0, static_cast<int>(row)), &padded[i], kernel[i], width);
      }
    }
  });
  return filtered;
}

Image<float> filterColumns(const Image<float>& image, const Kernel& kernel) {
  const int radius = radiusOf(kernel);
  Image<float> filtered(image.width(), image.height());
  parallelFor(static_cast<size_t>(image.height()), kRowsAtOnce, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (size_t i = 0; i < kernel.size(); ++i) {
        const int from = std::clamp(y + static_cast<int>(i) - radius, 0, image.height() - 1);
        addScaled(&filtered(0, y), &image(0, from), kernel[i], image.width());
      }
    }
  });
  return filtered;
}

}  // namespace ocelli
