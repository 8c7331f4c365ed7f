#include "oc_core/scene/texture_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oc_core/image/color.h"

namespace ocelli {
namespace {

int wrapped(int i, int size, TextureWrap wrap) {
  const int period = (i % size + size) % size;
  switch (wrap) {
    case TextureWrap::kRepeat:
      return period;
    case TextureWrap::kMirror:
      return (i - period) / size % 2 == 0 ? period : size - 1 - period;
    case TextureWrap::kClamp:
      return std::clamp(i, 0, size - 1);
  }
  return period;
}

glm::vec3 linearPixel(const Rgb8& pixel) {
  return {linearFromSrgbByte(pixel.x), linearFromSrgbByte(pixel.y), linearFromSrgbByte(pixel.z)};
}

/// Of what `decode` makes of a pixel, bilinearly interpolated.
template <class Decode>
auto sampleBy(const Texture& texture, const glm::vec2& uv, const Decode& decode) {
  const Image<Rgb8>& image = texture.image;
  // Beyond this, a float has no fraction left to sample with.
  constexpr float kMaxTurns = 1e5f;
  if (!(std::abs(uv.x) < kMaxTurns && std::abs(uv.y) < kMaxTurns)) {
    return decode(image(0, 0));
  }
  const double x = static_cast<double>(uv.x) * image.width() - 0.5;
  const double y = (1 - static_cast<double>(uv.y)) * image.height() - 0.5;
  constexpr double kMaxIndex = std::numeric_limits<int>::max() - 1;
  const int left = static_cast<int>(std::clamp(std::floor(x), -kMaxIndex, kMaxIndex));
  const int top = static_cast<int>(std::clamp(std::floor(y), -kMaxIndex, kMaxIndex));
  const auto at = [&](int i, int j) {
    return decode(image(wrapped(i, image.width(), texture.wrapU), wrapped(j, image.height(), texture.wrapV)));
  };
  const auto fx = static_cast<float>(x - left);
  const auto fy = static_cast<float>(y - top);
  const auto upper = at(left, top) * (1 - fx) + at(left + 1, top) * fx;
  const auto lower = at(left, top + 1) * (1 - fx) + at(left + 1, top + 1) * fx;
  return upper * (1 - fy) + lower * fy;
}

float valueOfPixel(const Rgb8& pixel) {
  return static_cast<float>(pixel.x) / 255.0f;
}

/// `mean` makes one pixel of four.
template <class Mean>
Texture halvedBy(const Texture& texture, const Mean& mean) {
  const Image<Rgb8>& image = texture.image;
  Texture half{Image<Rgb8>((image.width() + 1) / 2, (image.height() + 1) / 2), texture.wrapU, texture.wrapV};
  for (int y = 0; y < half.image.height(); ++y) {
    for (int x = 0; x < half.image.width(); ++x) {
      const int right = std::min(2 * x + 1, image.width() - 1);
      const int below = std::min(2 * y + 1, image.height() - 1);
      half.image(x, y) = mean(image(2 * x, 2 * y), image(right, 2 * y), image(2 * x, below), image(right, below));
    }
  }
  return half;
}

}  // namespace

glm::vec3 Texture::sample(const glm::vec2& uv) const {
  return sampleBy(*this, uv, linearPixel);
}

float Texture::value(const glm::vec2& uv) const {
  return sampleBy(*this, uv, valueOfPixel);
}

Texture Texture::halved() const {
  return halvedBy(*this, [](const Rgb8& a, const Rgb8& b, const Rgb8& c, const Rgb8& d) {
    const glm::vec3 mean = (linearPixel(a) + linearPixel(b) + linearPixel(c) + linearPixel(d)) * 0.25f;
    return Rgb8(srgbByteFromLinear(mean.x), srgbByteFromLinear(mean.y), srgbByteFromLinear(mean.z));
  });
}

Texture Texture::halvedValues() const {
  return halvedBy(*this, [](const Rgb8& a, const Rgb8& b, const Rgb8& c, const Rgb8& d) {
    return Rgb8(static_cast<uint8_t>((a.x + b.x + c.x + d.x + 2) / 4));
  });
}

}  // namespace ocelli
