#include "oc_core/image/level_png.h"

#include <png.h>

#include <array>
#include <cstring>
#include <string>
#include <string_view>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"

namespace ocelli {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr size_t kHeaderBytes = 33;  // signature and IHDR
constexpr uint64_t kMaxLevelPixels = uint64_t{1} << 26U;

uint32_t bigEndian(std::string_view bytes, size_t at) {
  uint32_t value = 0;
  for (size_t i = 0; i < 4; ++i) {
    value = value << 8U | static_cast<uint8_t>(bytes[at + i]);
  }
  return value;
}

/// The file without the chunks that tell how its levels become light: libpng would apply them.
std::string withoutNotes(std::string_view bytes) {
  constexpr std::array<std::string_view, 3> kKept{"IHDR", "IDAT", "IEND"};
  std::string kept(kSignature);
  size_t at = kSignature.size();
  while (at + 12 <= bytes.size()) {
    const size_t length = bigEndian(bytes, at);
    const size_t end = std::min(bytes.size(), at + 12 + length);
    const std::string_view type = bytes.substr(at + 4, 4);
    for (const std::string_view name : kKept) {
      if (type == name) {
        kept.append(bytes.substr(at, end - at));
      }
    }
    at = end;
  }
  return kept;
}

}  // namespace

void writeLevelPng(const std::filesystem::path& path, const Image<uint16_t>& levels) {
  OC_CHECK(!levels.empty(), "an empty image has no PNG form");
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(levels.width());
  png.height = static_cast<png_uint_32>(levels.height());
  png.format = PNG_FORMAT_LINEAR_Y;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, levels.data(), 0, nullptr) == 0) {
    throw WorkError(std::string("cannot make a PNG of these depths (") + png.message + ")", path.string(),
                    "use a smaller image");
  }
  writeFile(path, std::string_view(bytes).substr(0, size));
}

Image<uint16_t> readLevelPng(const std::filesystem::path& path) {
  const std::string file = readFile(path);
  if (file.size() < kHeaderBytes || std::string_view(file).substr(0, kSignature.size()) != kSignature) {
    throw InputError("this is no PNG file", path.string(), "write depths as a grey PNG of 16 bits");
  }
  const int bits = static_cast<uint8_t>(file[24]);
  const int colorType = static_cast<uint8_t>(file[25]);
  if (bits != 16 || colorType != PNG_COLOR_TYPE_GRAY) {
    throw InputError("depths are levels of 16 bits in one channel; this PNG file has " + std::to_string(bits) +
                         " bits a channel" + (colorType == PNG_COLOR_TYPE_GRAY ? "" : ", and is not grey"),
                     path.string(), "write depths as a grey PNG of 16 bits");
  }
  if (uint64_t{bigEndian(file, 16)} * bigEndian(file, 20) > kMaxLevelPixels) {
    throw InputError("this PNG file is larger than 2^26 pixels", path.string(), "scale the image down");
  }
  const std::string bytes = withoutNotes(file);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto fail = [&] {
    const std::string reason = png.message;
    png_image_free(&png);
    throw InputError("cannot read this PNG file (" + reason + ")", path.string(), "check the file");
  };
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
    fail();
  }
  png.format = PNG_FORMAT_LINEAR_Y;
  Image<uint16_t> levels(static_cast<int>(png.width), static_cast<int>(png.height));
  if (png_image_finish_read(&png, nullptr, levels.data(), 0, nullptr) == 0) {
    fail();
  }
  return levels;
}

}  // namespace ocelli
