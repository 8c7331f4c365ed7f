// Images for the tests of what compares them.
#pragma once

#include <algorithm>
#include <random>

#include "oc_core/image/png_file.h"

namespace ocelli::test {

inline Image<Rgb8> plain(const Rgb8& color, int width = 24, int height = 18) {
  return {width, height, color};
}

inline Image<Rgb8> randomImage(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image<Rgb8> image(width, height);
  for (Rgb8& pixel : image) {
    for (int channel = 0; channel < 3; ++channel) {
      pixel[channel] = static_cast<uint8_t>(random() >> 24);
    }
  }
  return image;
}

/// A smooth image, so that noise on it is what one sees.
inline Image<Rgb8> gradient(int width = 48, int height = 36) {
  Image<Rgb8> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image(x, y) = Rgb8(60 + 2 * x, 60 + 3 * y, 140 - x);
    }
  }
  return image;
}

/// The same noise for every `amplitude`, up to so many levels in each channel.
inline Image<Rgb8> withNoise(Image<Rgb8> image, int amplitude, unsigned seed = 1) {
  std::mt19937 random(seed);
  for (Rgb8& pixel : image) {
    for (int channel = 0; channel < 3; ++channel) {
      const double share = static_cast<double>(random()) / 4294967296.0 * 2 - 1;
      pixel[channel] = static_cast<uint8_t>(std::clamp(pixel[channel] + static_cast<int>(share * amplitude), 0, 255));
    }
  }
  return image;
}

}  // namespace ocelli::test
