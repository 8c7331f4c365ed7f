#include "oc_core/image_codecs/zstd_codec.h"

#include <zstd.h>

#include <array>

#include "oc_core/base/check.h"
#include "oc_core/image_codecs/codec_error.h"
#include "oc_core/image_codecs/depth_prediction.h"

namespace ocelli {
namespace {

constexpr const char* kZstdName = "zstd";
constexpr int kZstdLevel = 12;

std::vector<std::byte> compressed(std::span<const std::byte> plain) {
  std::vector<std::byte> bytes(ZSTD_compressBound(plain.size()));
  const size_t size = ZSTD_compress(bytes.data(), bytes.size(), plain.data(), plain.size(), kZstdLevel);
  OC_CHECK(ZSTD_isError(size) == 0, "zstd has room for all that it makes");
  bytes.resize(size);
  return bytes;
}

/// One frame of exactly so many bytes.
std::vector<std::byte> decompressed(std::span<const std::byte> bytes, size_t size) {
  const bool isOneFrame = ZSTD_findFrameCompressedSize(bytes.data(), bytes.size()) == bytes.size();
  if (!isOneFrame || ZSTD_getFrameContentSize(bytes.data(), bytes.size()) != size) {
    failDecoding(kZstdName, "it is not one frame of this size");
  }
  std::vector<std::byte> plain(size);
  const size_t written = ZSTD_decompress(plain.data(), plain.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(written) != 0 || written != size) {
    failDecoding(kZstdName, "it is damaged");
  }
  return plain;
}

/// G, R - G, B - G; and back.
std::array<uint8_t, 3> channelsOf(const Rgb8& rgb) {
  return {rgb.y, static_cast<uint8_t>(rgb.x - rgb.y), static_cast<uint8_t>(rgb.z - rgb.y)};
}
Rgb8 colorOfChannels(const std::array<uint8_t, 3>& c) {
  return {static_cast<uint8_t>(c[1] + c[0]), c[0], static_cast<uint8_t>(c[2] + c[0])};
}

/// Of a pixel whose neighbours to the left and above are known.
uint8_t channelPrediction(const Image<std::array<uint8_t, 3>>& image, int x, int y, size_t channel) {
  const int a = x > 0 ? image(x - 1, y)[channel] : 0;
  const int b = y > 0 ? image(x, y - 1)[channel] : 0;
  const int c = x > 0 && y > 0 ? image(x - 1, y - 1)[channel] : 0;
  return static_cast<uint8_t>(medianPrediction(a, b, c));
}

}  // namespace

std::vector<std::byte> encodeZstd(const Image<Rgb8>& image, double /*quality*/) {
  Image<std::array<uint8_t, 3>> channels(image.width(), image.height());
  for (size_t i = 0; i < image.size(); ++i) {
    channels[i] = channelsOf(image[i]);
  }
  std::vector<std::byte> planes(3 * image.size());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (size_t c = 0; c < 3; ++c) {
        const auto rest = static_cast<uint8_t>(channels(x, y)[c] - channelPrediction(channels, x, y, c));
        planes[c * image.size() + image.index(x, y)] = static_cast<std::byte>(rest);
      }
    }
  }
  return compressed(planes);
}

Image<Rgb8> decodeZstd(std::span<const std::byte> bytes, glm::ivec2 expectedSize) {
  checkExpectedSize(kZstdName, expectedSize);
  Image<std::array<uint8_t, 3>> channels(expectedSize.x, expectedSize.y);
  const std::vector<std::byte> planes = decompressed(bytes, 3 * channels.size());
  Image<Rgb8> image(expectedSize.x, expectedSize.y);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      for (size_t c = 0; c < 3; ++c) {
        const auto rest = static_cast<uint8_t>(planes[c * image.size() + image.index(x, y)]);
        channels(x, y)[c] = static_cast<uint8_t>(channelPrediction(channels, x, y, c) + rest);
      }
      image(x, y) = colorOfChannels(channels(x, y));
    }
  }
  return image;
}

std::vector<std::byte> encodeZstdDepth(const Image<uint16_t>& image) {
  return compressed(depthResiduals(image));
}

Image<uint16_t> decodeZstdDepth(std::span<const std::byte> bytes, glm::ivec2 expectedSize) {
  checkExpectedSize(kZstdName, expectedSize);
  const size_t pixels = static_cast<size_t>(expectedSize.x) * static_cast<size_t>(expectedSize.y);
  return depthFromResiduals(decompressed(bytes, 2 * pixels), expectedSize);
}

}  // namespace ocelli
