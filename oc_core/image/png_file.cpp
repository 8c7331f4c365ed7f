#include "oc_core/image/png_file.h"

#include <png.h>

#include <string>
#include <string_view>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/parallel.h"
#include "oc_core/image/color.h"

namespace ocelli {
namespace {

static_assert(sizeof(Rgb8) == 3, "rows of Rgb8 are handed to libpng as they stand");

png_image emptyPngImage() {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  return png;
}

}  // namespace

void writePng(const std::filesystem::path& path, const Image<Rgb8>& image) {
  OC_CHECK(!image.empty(), "an empty image has no PNG form");
  png_image png = emptyPngImage();
  png.width = static_cast<png_uint_32>(image.width());
  png.height = static_cast<png_uint_32>(image.height());
  png.format = PNG_FORMAT_RGB;
  // Into memory and not into the file: on failure libpng removes what it was told to write to, devices included.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.data(), 0, nullptr) == 0) {
    throw WorkError(std::string("cannot make a PNG of this image (") + png.message + ")", path.string(),
                    "use a smaller image");
  }
  writeFile(path, std::string_view(bytes).substr(0, size));
}

Image<Rgb8> readPng(const std::filesystem::path& path) {
  png_image png = emptyPngImage();
  const auto fail = [&] {
    const std::string reason = png.message;
    png_image_free(&png);
    throw InputError("cannot read this PNG file (" + reason + ")", path.string(), "check the path and the file");
  };
  if (png_image_begin_read_from_file(&png, path.c_str()) == 0) {
    fail();
  }
  png.format = PNG_FORMAT_RGB;
  constexpr png_uint_32 kMaxPixels = 1u << 28;
  if (png.width == 0 || png.height == 0 || png.width > kMaxPixels / png.height) {
    png_image_free(&png);
    throw InputError("this PNG file is larger than 2^28 pixels", path.string(), "scale the image down");
  }
  Image<Rgb8> image(static_cast<int>(png.width), static_cast<int>(png.height));
  const png_color black{0, 0, 0};
  if (png_image_finish_read(&png, &black, image.data(), 0, nullptr) == 0) {
    fail();
  }
  return image;
}

Image<Rgb8> srgbFromLinear(const Image<glm::vec3>& linear) {
  Image<Rgb8> encoded(linear.width(), linear.height());
  parallelFor(linear.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      encoded[i] = {srgbByteFromLinear(linear[i].x), srgbByteFromLinear(linear[i].y), srgbByteFromLinear(linear[i].z)};
    }
  });
  return encoded;
}

}  // namespace ocelli
