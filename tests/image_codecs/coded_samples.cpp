#include "tests/image_codecs/coded_samples.h"

#include <cmath>

#include "oc_core/base/random_numbers.h"

namespace ocelli::test {
namespace {

bool isInDisc(int x, int y, int width, int height) {
  return std::hypot(x - width * 0.6, y - height * 0.5) < 0.3 * height;
}

}  // namespace

Image<Rgb8> coloredDisc(int width, int height) {
  Image<Rgb8> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto across = static_cast<uint8_t>(255 * x / width);
      const auto down = static_cast<uint8_t>(255 * y / height);
      image(x, y) = isInDisc(x, y, width, height) ? Rgb8(220, 40, down) : Rgb8(across, down, 90);
    }
  }
  return image;
}

Image<Rgb8> colorNoise(int width, int height) {
  RandomNumbers random(3);
  Image<Rgb8> image(width, height);
  for (Rgb8& rgb : image) {
    const uint64_t bits = random.bits();
    rgb = {static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8), static_cast<uint8_t>(bits >> 16)};
  }
  return image;
}

Image<uint16_t> depthOfDisc(int width, int height) {
  Image<uint16_t> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int plane = 2000 + 7 * x + 3 * y;
      const bool isNothing = x < width / 4 && y > height / 2;
      image(x, y) = static_cast<uint16_t>(isInDisc(x, y, width, height) ? 60000 : isNothing ? 0 : plane);
    }
  }
  return image;
}

Image<uint16_t> depthNoise(int width, int height) {
  RandomNumbers random(5);
  Image<uint16_t> image(width, height);
  for (uint16_t& value : image) {
    value = static_cast<uint16_t>(random.bits());
  }
  return image;
}

}  // namespace ocelli::test
