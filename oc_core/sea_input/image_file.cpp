#include "oc_core/sea_input/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <span>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/image_codecs/image_codec.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxFileBytes = size_t{1} << 28;

std::span<const uint8_t> bytesOfText(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

int bigEndian16(std::span<const uint8_t> bytes, size_t at) {
  return bytes[at] << 8 | bytes[at + 1];
}

/// The size stands in the first chunk.
std::optional<glm::ivec2> pngSize(std::span<const uint8_t> bytes) {
  constexpr size_t kWidth = 16;
  if (bytes.size() < kWidth + 8 || bytes[1] != 'P' || bytes[2] != 'N' || bytes[3] != 'G') {
    return std::nullopt;
  }
  const auto number = [&](size_t at) { return bigEndian16(bytes, at) << 16 | bigEndian16(bytes, at + 2); };
  return glm::ivec2(number(kWidth), number(kWidth + 4));
}

/// The size stands in the first segment that begins a frame; before it there may be any others.
std::optional<glm::ivec2> jpegSize(std::span<const uint8_t> bytes) {
  if (bytes.size() < 4 || bytes[0] != 0xff || bytes[1] != 0xd8) {
    return std::nullopt;
  }
  size_t at = 2;
  while (at + 9 < bytes.size()) {
    const int marker = bytes[at + 1];
    const bool isFrame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (bytes[at] != 0xff) {
      return std::nullopt;
    }
    if (isFrame) {
      return glm::ivec2(bigEndian16(bytes, at + 7), bigEndian16(bytes, at + 5));
    }
    at += marker == 0xff ? 1 : 2 + static_cast<size_t>(bigEndian16(bytes, at + 2));
  }
  return std::nullopt;
}

Image<Rgb8> readPngOfSize(const fs::path& path, const glm::ivec2& /*size*/) {
  return readPng(path);
}

Image<Rgb8> readJpegOfSize(const fs::path& path, const glm::ivec2& size) {
  const ColorCodec* codec = findColorCodec("jpeg");
  if (codec == nullptr) {
    throw InputError("this program was built without libjpeg", path.string(), "convert the images to PNG");
  }
  const std::string bytes = readFile(path, kMaxFileBytes);
  return codec->decode(std::as_bytes(std::span(bytes)), size);
}

struct ImageFileFormat {
  const char* ending;
  std::optional<glm::ivec2> (*size)(std::span<const uint8_t> bytes);
  Image<Rgb8> (*read)(const fs::path& path, const glm::ivec2& size);
};

constexpr std::array kFormats{ImageFileFormat{".png", pngSize, readPngOfSize},
                              ImageFileFormat{".jpg", jpegSize, readJpegOfSize},
                              ImageFileFormat{".jpeg", jpegSize, readJpegOfSize}};

const ImageFileFormat* formatOf(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const ImageFileFormat& f) { return ending == f.ending; });
  return found == kFormats.end() ? nullptr : &*found;
}

const ImageFileFormat& requireFormat(const fs::path& path) {
  const ImageFileFormat* format = formatOf(path);
  if (format == nullptr) {
    throw InputError("images of a sea are PNG or JPEG files", path.string(), "convert it");
  }
  return *format;
}

}  // namespace

bool isImageFile(const fs::path& path) {
  return formatOf(path) != nullptr;
}

glm::ivec2 imageFileSize(const fs::path& path) {
  const ImageFileFormat& format = requireFormat(path);
  const std::string bytes = readFile(path, kMaxFileBytes);
  const std::optional<glm::ivec2> size = format.size(bytesOfText(bytes));
  if (!size || size->x <= 0 || size->y <= 0) {
    throw InputError(fmt::format("this is no {} image", format.ending + 1), path.string(), "convert it anew");
  }
  return *size;
}

Image<Rgb8> readImageFile(const fs::path& path, const glm::ivec2& size) {
  const ImageFileFormat& format = requireFormat(path);
  const glm::ivec2 found = imageFileSize(path);
  if (found != size) {
    throw InputError(
        fmt::format("this image is of {}x{} pixels, the others are of {}x{}", found.x, found.y, size.x, size.y),
        path.string(), "scale it, or leave it out: all images of a sea have one size");
  }
  return format.read(path, size);
}

}  // namespace ocelli
