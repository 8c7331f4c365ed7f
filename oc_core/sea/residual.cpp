#include "oc_core/sea/residual.h"

#include <cmath>
#include <cstdlib>

namespace ocelli {
namespace {

constexpr int kZero = 128;

const uint8_t* bytesOf(const Image<Rgb8>& image) {
  return &image.data()->r;
}

uint8_t* bytesOf(Image<Rgb8>& image) {
  return &image.data()->r;
}

}  // namespace

Image<Rgb8> residualOf(const Image<Rgb8>& image, const Image<Rgb8>& predicted) {
  OC_CHECK(image.width() == predicted.width() && image.height() == predicted.height(), "images of one size");
  Image<Rgb8> residual(image.width(), image.height());
  const uint8_t* whole = bytesOf(image);
  const uint8_t* known = bytesOf(predicted);
  uint8_t* to = bytesOf(residual);
  for (size_t i = 0; i < 3 * image.size(); ++i) {
    // Rounded towards zero, so that nothing is said of differences of one.
    to[i] = static_cast<uint8_t>(kZero + (int{whole[i]} - int{known[i]}) / 2);
  }
  return residual;
}

double residualEnergy(const Image<Rgb8>& image, const Image<Rgb8>& predicted) {
  OC_CHECK(image.width() == predicted.width() && image.height() == predicted.height(), "images of one size");
  // Rec. 601, in 1/1000, of the encoded values: the sum fits 63 bits.
  int64_t sum = 0;
  for (size_t i = 0; i < image.size(); ++i) {
    const Rgb8& a = image[i];
    const Rgb8& b = predicted[i];
    sum += std::abs(299 * (int{a.r} - int{b.r}) + 587 * (int{a.g} - int{b.g}) + 114 * (int{a.b} - int{b.b}));
  }
  return image.empty() ? 0 : static_cast<double>(sum) / 1000.0 / static_cast<double>(image.size());
}

}  // namespace ocelli
