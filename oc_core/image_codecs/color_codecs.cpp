#include <algorithm>

#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/image_codecs/png_codec.h"
#include "oc_core/image_codecs/zstd_codec.h"
#ifdef OCELLI_WITH_JPEG
#include "oc_core/image_codecs/jpeg_codec.h"
#endif
#ifdef OCELLI_WITH_WEBP
#include "oc_core/image_codecs/webp_codec.h"
#endif
#ifdef OCELLI_WITH_JXL
#include "oc_core/image_codecs/jxl_codec.h"
#endif

namespace ocelli {

std::span<const ColorCodec> colorCodecs() {
  static constexpr ColorCodec kRows[]{
      {.name = "png",
       .mediaType = "image/png",
       .meaning = "lossless, and shown by every browser",
       .isLossless = true,
       .inBrowsers = true,
       .encode = encodePng,
       .decode = decodePng},
#ifdef OCELLI_WITH_JPEG
      {.name = "jpeg",
       .mediaType = "image/jpeg",
       .meaning = "progressive, with libjpeg",
       .isLossless = false,
       .inBrowsers = true,
       .encode = encodeJpeg,
       .decode = decodeJpeg},
      {.name = "jpeg_baseline",
       .mediaType = "image/jpeg",
       .meaning = "not progressive, with libjpeg",
       .isLossless = false,
       .inBrowsers = true,
       .encode = encodeBaselineJpeg,
       .decode = decodeJpeg},
#endif
#ifdef OCELLI_WITH_WEBP
      {.name = "webp",
       .mediaType = "image/webp",
       .meaning = "lossy WebP",
       .isLossless = false,
       .inBrowsers = true,
       .encode = encodeWebp,
       .decode = decodeWebp},
      {.name = "webp_lossless",
       .mediaType = "image/webp",
       .meaning = "lossless WebP",
       .isLossless = true,
       .inBrowsers = true,
       .encode = encodeLosslessWebp,
       .decode = decodeWebp},
#endif
#ifdef OCELLI_WITH_JXL
      {.name = "jxl",
       .mediaType = "image/jxl",
       .meaning = "JPEG XL, lossless at a quality of 100",
       .isLossless = false,
       .inBrowsers = false,
       .encode = encodeJxl,
       .decode = decodeJxl},
#endif
      {.name = "zstd",
       .mediaType = "application/zstd",
       .meaning = "lossless: predicted from neighbours, then zstd",
       .isLossless = true,
       .inBrowsers = false,
       .encode = encodeZstd,
       .decode = decodeZstd},
  };
  return kRows;
}

const ColorCodec* findColorCodec(std::string_view name) {
  const auto row = std::ranges::find(colorCodecs(), name, &ColorCodec::name);
  return row == colorCodecs().end() ? nullptr : &*row;
}

}  // namespace ocelli
