#include "oc_core/scene/texture_image.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>

#include "oc_core/base/color.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr int kMostPixels = 1 << 28;

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

}  // namespace

glm::vec3 Texture::sample(const glm::vec2& uv) const {
  // Beyond this, a float has no fraction left to sample with.
  constexpr float kMostTurns = 1e5f;
  if (!(std::abs(uv.x) < kMostTurns && std::abs(uv.y) < kMostTurns)) {
    return linearPixel(image(0, 0));
  }
  const double x = static_cast<double>(uv.x) * image.width() - 0.5;
  const double y = (1 - static_cast<double>(uv.y)) * image.height() - 0.5;
  constexpr double kMostIndex = std::numeric_limits<int>::max() - 1;
  const int left = static_cast<int>(std::clamp(std::floor(x), -kMostIndex, kMostIndex));
  const int top = static_cast<int>(std::clamp(std::floor(y), -kMostIndex, kMostIndex));
  const auto at = [&](int i, int j) {
    return linearPixel(image(wrapped(i, image.width(), wrapU), wrapped(j, image.height(), wrapV)));
  };
  const auto fx = static_cast<float>(x - left);
  const auto fy = static_cast<float>(y - top);
  const glm::vec3 upper = at(left, top) * (1 - fx) + at(left + 1, top) * fx;
  const glm::vec3 lower = at(left, top + 1) * (1 - fx) + at(left + 1, top + 1) * fx;
  return upper * (1 - fy) + lower * fy;
}

Texture Texture::halved() const {
  Texture half{Image<Rgb8>((image.width() + 1) / 2, (image.height() + 1) / 2), wrapU, wrapV};
  for (int y = 0; y < half.image.height(); ++y) {
    for (int x = 0; x < half.image.width(); ++x) {
      const int right = std::min(2 * x + 1, image.width() - 1);
      const int below = std::min(2 * y + 1, image.height() - 1);
      const glm::vec3 mean = (linearPixel(image(2 * x, 2 * y)) + linearPixel(image(right, 2 * y)) +
                              linearPixel(image(2 * x, below)) + linearPixel(image(right, below))) *
                             0.25f;
      half.image(x, y) = {srgbByteFromLinear(mean.x), srgbByteFromLinear(mean.y), srgbByteFromLinear(mean.z)};
    }
  }
  return half;
}

Image<Rgb8> decodeImage(const std::vector<unsigned char>& bytes, const std::string& where) {
  const auto fail = [&](const std::string& what) {
    throw InputError(what, where, "convert the texture to PNG or JPEG, or load the scene with --no-textures");
  };
  int width = 0;
  int height = 0;
  int channels = 0;
  const auto* data = bytes.data();
  const int size = static_cast<int>(std::min<size_t>(bytes.size(), std::numeric_limits<int>::max()));
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0 || width <= 0 || height <= 0) {
    fail("cannot read this texture (" + std::string(stbi_failure_reason()) + ")");
  }
  if (width > kMostPixels / height) {
    fail("this texture has more than 2^28 pixels");
  }
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(data, size, &width, &height, &channels, 3), stbi_image_free);
  if (pixels == nullptr) {
    fail("cannot read this texture (" + std::string(stbi_failure_reason()) + ")");
  }
  Image<Rgb8> image(width, height);
  std::copy_n(pixels.get(), image.size() * 3, &image.data()->x);
  return image;
}

Image<Rgb8> readImage(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (bytes.empty()) {
    throw InputError("there is no such texture file, or it is empty", path.string(),
                     "put the image there, or load the scene with --no-textures");
  }
  return decodeImage(bytes, path.string());
}

}  // namespace ocelli
