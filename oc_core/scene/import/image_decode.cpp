#include "oc_core/scene/import/image_decode.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/scene/texture_image.h"

namespace ocelli {

namespace {

struct DecodedPixels {
  std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> bytes{nullptr, stbi_image_free};
  int width = 0;
  int height = 0;
};

/// Each pixel of so many channels: 3 of colour, 4 with alpha, or 2: brightness and alpha.
DecodedPixels decodePixels(std::span<const unsigned char> bytes, int wanted, const std::string& where,
                           const MemoryNotice& notice) {
  const auto fail = [&](const std::string& what) {
    throw InputError(what, where, "convert the texture to PNG or JPEG, or load the scene with --no-textures");
  };
  if (bytes.size() > std::numeric_limits<int>::max()) {
    fail("this texture is larger than 2 GiB");
  }
  int width = 0;
  int height = 0;
  int channels = 0;
  const auto* data = bytes.data();
  const int size = static_cast<int>(bytes.size());
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0 || width <= 0 || height <= 0) {
    fail("cannot read this texture (" + std::string(stbi_failure_reason()) + ")");
  }
  const uint64_t pixelCount = static_cast<uint64_t>(width) * static_cast<uint64_t>(height);
  if (pixelCount > kMaxTexturePixels) {
    fail("this texture has more than 2^28 pixels");
  }
  if (notice) {
    // What is decoded, converted to 3 channels, and copied; of 16 bits at most, 4 channels at most.
    constexpr uint64_t kBytesPerPixel = 8 + 4 + 2 * sizeof(Rgb8);
    notice(pixelCount * kBytesPerPixel);
  }
  DecodedPixels pixels;
  pixels.bytes.reset(stbi_load_from_memory(data, size, &pixels.width, &pixels.height, &channels, wanted));
  if (pixels.bytes == nullptr) {
    fail("cannot read this texture (" + std::string(stbi_failure_reason()) + ")");
  }
  return pixels;
}

}  // namespace

Image<Rgb8> decodeImage(std::span<const unsigned char> bytes, const std::string& where, const MemoryNotice& notice) {
  const DecodedPixels pixels = decodePixels(bytes, 3, where, notice);
  Image<Rgb8> image(pixels.width, pixels.height);
  std::copy_n(pixels.bytes.get(), image.size() * 3, &image.data()->x);
  return image;
}

std::optional<Image<Rgb8>> decodeOpacity(std::span<const unsigned char> bytes, bool orBrightness,
                                         const std::string& where, const MemoryNotice& notice) {
  const DecodedPixels pixels = decodePixels(bytes, 2, where, notice);
  Image<Rgb8> image(pixels.width, pixels.height);
  const std::span<const stbi_uc> values(pixels.bytes.get(), image.size() * 2);
  bool isTransparent = false;
  for (size_t i = 0; i < image.size(); ++i) {
    isTransparent = isTransparent || values[2 * i + 1] != 255;
  }
  if (!isTransparent && !orBrightness) {
    return std::nullopt;
  }
  for (size_t i = 0; i < image.size(); ++i) {
    image[i] = Rgb8(values[2 * i + (isTransparent ? 1 : 0)]);
  }
  return image;
}

std::string readImageBytes(const std::filesystem::path& path, const MemoryNotice& notice) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    throw InputError("there is no such texture file", path.string(),
                     "put the image there, or load the scene with --no-textures");
  }
  if (notice) {
    notice(std::filesystem::file_size(path, ignored));
  }
  return readFile(path, std::numeric_limits<int>::max());
}

Image<Rgb8> readImage(const std::filesystem::path& path, const MemoryNotice& notice) {
  const std::string bytes = readImageBytes(path, notice);
  return decodeImage({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, path.string(), notice);
}

}  // namespace ocelli
