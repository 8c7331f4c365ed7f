#include <algorithm>
#include <array>

#include "oc_core/image_codecs/deflate_codec.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/image_codecs/png_codec.h"

namespace ocelli {

std::span<const DepthCodec> depthCodecs() {
  static constexpr std::array kRows{
      DepthCodec{.name = "png",
                 .mediaType = "image/png",
                 .meaning = "high byte in red, low byte in green",
                 .inBrowsers = true,
                 .encode = encodePngDepth,
                 .decode = decodePngDepth},
      DepthCodec{.name = "deflate",
                 .mediaType = "application/zlib",
                 .meaning = "predicted from neighbours, then zlib",
                 .inBrowsers = true,
                 .encode = encodeDeflateDepth,
                 .decode = decodeDeflateDepth},
  };
  return kRows;
}

const DepthCodec* findDepthCodec(std::string_view name) {
  const auto row = std::ranges::find(depthCodecs(), name, &DepthCodec::name);
  return row == depthCodecs().end() ? nullptr : &*row;
}

}  // namespace ocelli
