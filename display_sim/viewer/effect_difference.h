// How far the picture of an effect is from the traced one, pixel by pixel: as figures, and as heat.
#pragma once

#include <cstddef>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// The difference of a pixel is that of its red, green or blue, whichever is largest: of sRGB values from 0 to 255.
struct EffectDifference {
  /// As heat (heatOf()) where they differ, and the traced picture in dark grey where they don't; as large as both.
  Image<Rgb8> heat;
  size_t pixels = 0;
  size_t different = 0;         ///< in any of their bits
  size_t clearlyDifferent = 0;  ///< by more than kClearDifference
  double psnrDecibels = 0;      ///< over all pixels; infinite where the pictures are equal

  double clearShare() const {
    return pixels > 0 ? static_cast<double>(clearlyDifferent) / static_cast<double>(pixels) : 0;
  }
};

/// A sixteenth of the range: smaller ones are hard to see in a picture.
inline constexpr int kClearDifference = 16;
/// Differences from here on are the brightest heat: a quarter of the range.
inline constexpr int kHottestDifference = 64;

/// From kRampDark for none to kRampLight (viewer_colors.h), linearly.
Rgb8 heatOf(int difference);
/// Darker than any heat.
Rgb8 dimmedGrey(const Rgb8& color);

/// The pictures have the same size, of one pixel at least.
EffectDifference differenceOf(const Image<Rgb8>& picture, const Image<Rgb8>& traced);

}  // namespace ocelli
