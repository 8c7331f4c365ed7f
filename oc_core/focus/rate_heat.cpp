#include "oc_core/focus/rate_heat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/drawing/color_scale.h"

namespace ocelli {
namespace {

constexpr double kPictureShare = 0.45;  ///< of the brightness; the rest is the rate
constexpr int kTableColors = 512;

double shareOf(double rate, const RateRange& range) {
  const double least = std::log2(range.least);
  const double span = std::log2(range.greatest) - least;
  return span > 0 ? std::clamp((std::log2(rate) - least) / span, 0.0, 1.0) : 0.5;
}

glm::dvec3 paintAt(double share) {
  const Paint paint = scaleColor(share);
  return {paint.red, paint.green, paint.blue};
}

Rgb8 bytesOf(const glm::dvec3& color) {
  return {glm::round(glm::clamp(color, 0.0, 1.0) * 255.0)};
}

double brightnessOf(const Rgb8& pixel) {
  return (0.2126 * pixel.x + 0.7152 * pixel.y + 0.0722 * pixel.z) / 255;
}

}  // namespace

Rgb8 rateColor(double rate, const RateRange& range) {
  return bytesOf(paintAt(shareOf(rate, range)));
}

Image<Rgb8> rateHeat(const Image<float>& rates, const RateRange& range, const Image<Rgb8>& picture) {
  OC_CHECK(picture.empty() || (picture.width() == rates.width() && picture.height() == rates.height()),
           "the picture is of the size of the rates");
  std::array<glm::dvec3, kTableColors + 1> table;
  for (int i = 0; i <= kTableColors; ++i) {
    table[static_cast<size_t>(i)] = paintAt(static_cast<double>(i) / kTableColors);
  }
  Image<Rgb8> heat(rates.width(), rates.height());
  parallelFor(rates.size(), 1 << 13, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const double share = shareOf(static_cast<double>(rates[i]), range);
      const double light = picture.empty() ? 1 : 1 - kPictureShare + kPictureShare * brightnessOf(picture[i]);
      heat[i] = bytesOf(table[static_cast<size_t>(std::lround(share * kTableColors))] * light);
    }
  });
  return heat;
}

}  // namespace ocelli
