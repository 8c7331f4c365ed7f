#include "display_sim/viewer/effect_difference.h"

#include <algorithm>
#include <cstdlib>

#include "display_sim/viewer/viewer_colors.h"
#include "oc_core/image/image_error.h"

namespace ocelli {

Rgb8 heatOf(int difference) {
  const int share = std::min(difference, kHottestDifference);
  const auto between = [&](int dark, int light) {
    return static_cast<uint8_t>(dark + (light - dark) * share / kHottestDifference);
  };
  return {between(kRampDark.red, kRampLight.red), between(kRampDark.green, kRampLight.green),
          between(kRampDark.blue, kRampLight.blue)};
}

Rgb8 dimmedGrey(const Rgb8& color) {
  constexpr int kDimmed = 8;  // of 256 levels 32, and kRampDark has a luma of 32
  const auto grey = static_cast<uint8_t>((299 * color.x + 587 * color.y + 114 * color.z) / (1000 * kDimmed));
  return {grey, grey, grey};
}

EffectDifference differenceOf(const Image<Rgb8>& picture, const Image<Rgb8>& traced) {
  OC_CHECK(picture.width() == traced.width() && picture.height() == traced.height() && !traced.empty(),
           "pictures that are compared have the same size");
  EffectDifference result;
  result.heat = Image<Rgb8>(traced.width(), traced.height());
  result.pixels = traced.size();
  for (size_t i = 0; i < traced.size(); ++i) {
    int largest = 0;
    for (int channel = 0; channel < 3; ++channel) {
      largest = std::max(largest, std::abs(int{picture[i][channel]} - int{traced[i][channel]}));
    }
    result.heat[i] = largest > 0 ? heatOf(largest) : dimmedGrey(traced[i]);
    result.different += largest > 0;
    result.clearlyDifferent += largest > kClearDifference;
  }
  result.psnrDecibels = psnrDecibels(meanSquaredError(picture, traced));
  return result;
}

}  // namespace ocelli
