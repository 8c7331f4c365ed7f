#include "oc_core/image_codecs/png_codec.h"

#include <png.h>

#include "oc_core/base/error.h"
#include "oc_core/image_codecs/codec_error.h"

namespace ocelli {
namespace {

constexpr const char* kPngName = "PNG";

png_image emptyCodedPng() {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  return png;
}

}  // namespace

std::vector<std::byte> encodePng(const Image<Rgb8>& image, double /*quality*/) {
  png_image png = emptyCodedPng();
  png.width = static_cast<png_uint_32>(image.width());
  png.height = static_cast<png_uint_32>(image.height());
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::vector<std::byte> bytes(size);
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.data(), 0, nullptr) == 0) {
    throw WorkError(std::string("cannot make a PNG of this image (") + png.message + ")", "image", "use a smaller one");
  }
  bytes.resize(size);
  return bytes;
}

Image<Rgb8> decodePng(std::span<const std::byte> bytes, glm::ivec2 expectedSize) {
  checkExpectedSize(kPngName, expectedSize);
  png_image png = emptyCodedPng();
  const auto fail = [&] {
    const std::string reason = png.message;
    png_image_free(&png);
    failDecoding(kPngName, reason);
  };
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
    fail();
  }
  if (png.width != static_cast<png_uint_32>(expectedSize.x) || png.height != static_cast<png_uint_32>(expectedSize.y)) {
    const auto [width, height] = std::pair(png.width, png.height);
    png_image_free(&png);
    checkDecodedSize(kPngName, width, height, expectedSize);
  }
  png.format = PNG_FORMAT_RGB;
  Image<Rgb8> image(expectedSize.x, expectedSize.y);
  const png_color black{0, 0, 0};
  if (png_image_finish_read(&png, &black, image.data(), 0, nullptr) == 0) {
    fail();
  }
  return image;
}

std::vector<std::byte> encodePngDepth(const Image<uint16_t>& image) {
  Image<Rgb8> split(image.width(), image.height());
  for (size_t i = 0; i < image.size(); ++i) {
    split[i] = {static_cast<uint8_t>(image[i] >> 8), static_cast<uint8_t>(image[i] & 0xff), 0};
  }
  return encodePng(split, 0);
}

Image<uint16_t> decodePngDepth(std::span<const std::byte> bytes, glm::ivec2 expectedSize) {
  const Image<Rgb8> split = decodePng(bytes, expectedSize);
  Image<uint16_t> image(split.width(), split.height());
  for (size_t i = 0; i < image.size(); ++i) {
    image[i] = static_cast<uint16_t>(split[i].x << 8 | split[i].y);
  }
  return image;
}

}  // namespace ocelli
