// WarpReference, and what is drawn with it in plain steps.
#include <algorithm>
#include <array>
#include <cmath>

#include "oc_core/sea/cubic_weights.h"
#include "oc_core/sea/warped_image.h"

namespace ocelli {
namespace {

/// The pixel of the image that stands at a place of the rim.
glm::ivec2 pixelOfRim(int x, int y, const SeaProjection& projection) {
  if (!projection.wraps()) {
    return {std::clamp(x, 0, projection.width - 1), std::clamp(y, 0, projection.height - 1)};
  }
  // Beyond a pole one comes down on the other side.
  if (y < 0 || y >= projection.height) {
    y = y < 0 ? -1 - y : 2 * projection.height - 1 - y;
    x += projection.width / 2;
  }
  return {(x % projection.width + projection.width) % projection.width, y};
}

}  // namespace

WarpReference::WarpReference(const Image<Rgb8>& image, const SeaProjection& projection)
    : width_(image.width()), height_(image.height()), projection_(projection) {
  OC_CHECK(image.width() == projection.width && image.height() == projection.height, "an image of the projection");
  pixels_.resize(3 * planeBytes());
  std::array<uint8_t*, 3> to{pixels_.data(), pixels_.data() + planeBytes(), pixels_.data() + 2 * planeBytes()};
  const auto put = [&](const Rgb8& pixel) {
    *to[0]++ = pixel.r;
    *to[1]++ = pixel.g;
    *to[2]++ = pixel.b;
  };
  for (int y = -kRim; y < height_ + kRim; ++y) {
    const bool isRow = y >= 0 && y < height_;
    for (int x = -kRim; x < width_ + kRim; ++x) {
      if (isRow && x == 0) {
        for (; x < width_; ++x) {
          put(image(x, y));
        }
      }
      const glm::ivec2 from = pixelOfRim(x, y, projection);
      put(image(from.x, from.y));
    }
  }
}

Image<Rgb8> WarpReference::image() const {
  Image<Rgb8> image(width_, height_);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      image(x, y) = at(x, y);
    }
  }
  return image;
}

Image<Rgb8> plainWarpedImage(const WarpReference& reference, const WarpMap& map) {
  Image<Rgb8> image(map.width(), map.height(), Rgb8(0));
  const auto width = static_cast<float>(reference.width());
  for (size_t i = 0; i < map.size(); ++i) {
    if (!isSeen(map[i])) {
      continue;
    }
    const float u = reference.projection().wraps() ? map[i].x - width * std::floor(map[i].x / width) : map[i].x;
    const float x = std::floor(u - 0.5f);
    const float y = std::floor(map[i].y - 0.5f);
    const std::array<float, 4> across = cubicWeights(u - 0.5f - x);
    const std::array<float, 4> down = cubicWeights(map[i].y - 0.5f - y);
    std::array<float, 3> sum{};
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        const Rgb8 pixel = reference.at(static_cast<int>(x) - 1 + column, static_cast<int>(y) - 1 + row);
        const float weight = across[static_cast<size_t>(column)] * down[static_cast<size_t>(row)];
        for (size_t c = 0; c < 3; ++c) {
          sum[c] += weight * static_cast<float>(pixel[static_cast<int>(c)]);
        }
      }
    }
    for (size_t c = 0; c < 3; ++c) {
      image[i][static_cast<int>(c)] = static_cast<uint8_t>(std::lround(std::clamp(sum[c], 0.0f, 255.0f)));
    }
  }
  return image;
}

}  // namespace ocelli
