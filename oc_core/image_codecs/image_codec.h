// Images as bytes, for links and files: a row for each format, of 8-bit colours and of 16-bit depths.
//
// All of them compress with packages of the system, and this is the only room that knows them. A row is missing where
// the toolkit was built without its package (docs/install.md): OCELLI_WITH_JPEG, OCELLI_WITH_WEBP, OCELLI_WITH_JXL.
//
// Recipe for a new one, two places:
//   1. oc_core/image_codecs/NAME_codec.h and .cpp: its functions; they must hold for hostile bytes what is said below;
//   2. oc_core/image_codecs/color_codecs.cpp, or depth_codecs.cpp in its place: its row. The tests run over all rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// No codec takes or gives an image with more pixels, or with a longer side.
inline constexpr int64_t kMaxCodedPixels = int64_t{1} << 24;
inline constexpr int kMaxCodedSide = 16383;  ///< that of WebP

struct ColorCodec {
  const char* name;
  const char* mediaType;  ///< what HTTP calls the bytes
  const char* meaning;    ///< a sentence without its full stop
  bool isLossless;        ///< what is decoded is what was encoded, at any quality
  bool inBrowsers;        ///< Chromium and Firefox decode it by themselves
  /// `quality` is from 0 to 100, as each format takes it; lossless formats ignore it. The image has pixels, at most
  /// kMaxCodedPixels. Any thread may call it.
  std::vector<std::byte> (*encode)(const Image<Rgb8>& image, double quality);
  /// Throws InputError for bytes that are no such image of this size; deflate and zstd know the number of pixels alone.
  /// Needs memory for the image and a part of it again, whatever the bytes say.
  Image<Rgb8> (*decode)(std::span<const std::byte> bytes, glm::ivec2 expectedSize);
};

/// Depths, or whatever 16-bit values are. All of these are lossless.
struct DepthCodec {
  const char* name;
  const char* mediaType;
  const char* meaning;
  bool inBrowsers;  ///< a page decodes it with what Chromium and Firefox have and a few lines of JavaScript
  std::vector<std::byte> (*encode)(const Image<uint16_t>& image);
  /// As ColorCodec::decode.
  Image<uint16_t> (*decode)(std::span<const std::byte> bytes, glm::ivec2 expectedSize);
};

std::span<const ColorCodec> colorCodecs();
std::span<const DepthCodec> depthCodecs();
/// Nothing for a name that no row has.
const ColorCodec* findColorCodec(std::string_view name);
const DepthCodec* findDepthCodec(std::string_view name);

}  // namespace ocelli
