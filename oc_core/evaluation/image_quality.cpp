#include "oc_core/evaluation/image_quality.h"

#include <cmath>
#include <cstdint>

#include "oc_core/evaluation/separable_filter.h"

namespace ocelli {
namespace {

constexpr float kWindowSigma = 1.5f;
constexpr int kWindowRadius = 5;
constexpr float kC1 = 0.01f * 255 * 0.01f * 255;
constexpr float kC2 = 0.03f * 255 * 0.03f * 255;

void checkSameSize(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  OC_CHECK(a.width() == b.width() && a.height() == b.height() && !a.empty(),
           "images to compare have the same size, and pixels");
}

Image<float> lumaOf(const Image<Rgb8>& image) {
  Image<float> luma(image.width(), image.height());
  for (size_t i = 0; i < image.size(); ++i) {
    const Rgb8& c = image[i];
    luma[i] = 0.299f * static_cast<float>(c.x) + 0.587f * static_cast<float>(c.y) + 0.114f * static_cast<float>(c.z);
  }
  return luma;
}

/// The mean over the window around each pixel.
Image<float> windowMean(const Image<float>& image) {
  static const Kernel window = gaussianKernel(kWindowSigma, kWindowRadius);
  return filterColumns(filterRows(image, window), window);
}

Image<float> product(const Image<float>& a, const Image<float>& b) {
  Image<float> products(a.width(), a.height());
  for (size_t i = 0; i < a.size(); ++i) {
    products[i] = a[i] * b[i];
  }
  return products;
}

}  // namespace

double ssim(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  checkSameSize(a, b);
  const Image<float> x = lumaOf(a);
  const Image<float> y = lumaOf(b);
  const Image<float> meanX = windowMean(x);
  const Image<float> meanY = windowMean(y);
  const Image<float> meanXx = windowMean(product(x, x));
  const Image<float> meanYy = windowMean(product(y, y));
  const Image<float> meanXy = windowMean(product(x, y));
  double sum = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    const float both = meanX[i] * meanY[i];
    const float squares = meanX[i] * meanX[i] + meanY[i] * meanY[i];
    const float variances = meanXx[i] + meanYy[i] - squares;
    const float covariance = meanXy[i] - both;
    sum += static_cast<double>((2 * both + kC1) * (2 * covariance + kC2) / ((squares + kC1) * (variances + kC2)));
  }
  return sum / static_cast<double>(x.size());
}

}  // namespace ocelli
