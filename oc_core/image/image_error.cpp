#include "oc_core/image/image_error.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "oc_core/base/check.h"

namespace ocelli {

double meanSquaredError(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  OC_CHECK(a.width() == b.width() && a.height() == b.height() && !a.empty(),
           "images to compare have the same size, and pixels");
  uint64_t sum = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const int difference = a[i][channel] - b[i][channel];
      sum += static_cast<uint64_t>(difference * difference);
    }
  }
  return static_cast<double>(sum) / (255.0 * 255.0 * 3.0 * static_cast<double>(a.size()));
}

double psnrDecibels(double meanSquaredError) {
  return meanSquaredError > 0 ? -10 * std::log10(meanSquaredError) : std::numeric_limits<double>::infinity();
}

}  // namespace ocelli
