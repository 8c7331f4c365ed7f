#include <algorithm>

#include "oc_core/image_codecs/deflate_codec.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/image_codecs/png_codec.h"
#include "oc_core/image_codecs/zstd_codec.h"
#ifdef OCELLI_WITH_WEBP
#include "oc_core/image_codecs/webp_codec.h"
#endif
#ifdef OCELLI_WITH_JXL
#include "oc_core/image_codecs/jxl_codec.h"
#endif

namespace ocelli {

std::span<const DepthCodec> depthCodecs() {
  static constexpr DepthCodec kRows[]{
      {.name = "png",
       .mediaType = "image/png",
       .meaning = "high byte in red, low byte in green",
       .inBrowsers = true,
       .encode = encodePngDepth,
       .decode = decodePngDepth},
      {.name = "deflate",
       .mediaType = "application/zlib",
       .meaning = "predicted from neighbours, then zlib",
       .inBrowsers = true,
       .encode = encodeDeflateDepth,
       .decode = decodeDeflateDepth},
      {.name = "zstd",
       .mediaType = "application/zstd",
       .meaning = "predicted from neighbours, then zstd",
       .inBrowsers = false,
       .encode = encodeZstdDepth,
       .decode = decodeZstdDepth},
#ifdef OCELLI_WITH_WEBP
      {.name = "webp",
       .mediaType = "image/webp",
       .meaning = "predicted from neighbours, then lossless WebP",
       .inBrowsers = true,
       .encode = encodeWebpDepth,
       .decode = decodeWebpDepth},
#endif
#ifdef OCELLI_WITH_JXL
      {.name = "jxl",
       .mediaType = "image/jxl",
       .meaning = "lossless JPEG XL of one channel of 16 bits",
       .inBrowsers = false,
       .encode = encodeJxlDepth,
       .decode = decodeJxlDepth},
#endif
  };
  return kRows;
}

const DepthCodec* findDepthCodec(std::string_view name) {
  const auto row = std::ranges::find(depthCodecs(), name, &DepthCodec::name);
  return row == depthCodecs().end() ? nullptr : &*row;
}

}  // namespace ocelli
