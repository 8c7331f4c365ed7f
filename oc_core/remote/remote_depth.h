// Depths as whole numbers: 0 where nothing is seen, else 1 to `levels`, linear in 1/z from the farthest sample to the
// nearest. What a translation of the eye moves a sample by in an image is proportional to 1/z, so that equal steps of
// it are equal errors in pixels, wherever a sample is.
#pragma once

#include <cstdint>

#include "oc_core/image/image.h"

namespace ocelli {

struct RemoteDepth {
  static constexpr int kMinLevels = 2;
  static constexpr int kMaxLevels = 65535;

  Image<uint16_t> values{};
  double inverseNear = 1;  ///< 1/z of the value `levels`; more than 0
  double inverseFar = 1;   ///< 1/z of the value 1; more than 0, and at most inverseNear
  int levels = kMinLevels;

  /// Of a value, or of what lies between two.
  double inverseDepth(double value) const {
    return inverseFar + (inverseNear - inverseFar) * (value - 1) / (levels - 1);
  }
};

/// `t` is z, and 0 where nothing is seen.
RemoteDepth roundedDepth(const Image<float>& t, int levels);

/// How many levels displace no sample by more than `error` pixels when the eye moves by `translation` times the
/// distance of the nearest sample. `focalPixels` is that of the densest samples.
int depthLevels(const Image<float>& t, double focalPixels, double translation, double error);

}  // namespace ocelli
