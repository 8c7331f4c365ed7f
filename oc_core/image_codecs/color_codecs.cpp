#include <algorithm>
#include <array>

#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/image_codecs/png_codec.h"

namespace ocelli {

std::span<const ColorCodec> colorCodecs() {
  static constexpr std::array kRows{
      ColorCodec{.name = "png",
                 .mediaType = "image/png",
                 .meaning = "lossless, and drawn by every browser",
                 .isLossless = true,
                 .inBrowsers = true,
                 .encode = encodePng,
                 .decode = decodePng},
  };
  return kRows;
}

const ColorCodec* findColorCodec(std::string_view name) {
  const auto row = std::ranges::find(colorCodecs(), name, &ColorCodec::name);
  return row == colorCodecs().end() ? nullptr : &*row;
}

}  // namespace ocelli
