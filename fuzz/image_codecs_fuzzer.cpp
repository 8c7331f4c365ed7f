// libFuzzer target: any bytes as a coded image. The first byte chooses the codec, the next two the size that is
// expected. Those of JPEG XL are left out: libjxl writes a line for whatever it refuses (tests/image_codecs/
// hostile_bytes_test.cpp has some).
#include <cstdlib>
#include <span>
#include <string_view>

#include "oc_core/base/error.h"
#include "oc_core/image_codecs/image_codec.h"

namespace {

using namespace ocelli;

constexpr std::string_view kLeftOut = "jxl";

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

void decodeColor(const ColorCodec& codec, std::span<const std::byte> bytes, const glm::ivec2& size) {
  const Image<Rgb8> image = codec.decode(bytes, size);
  require(image.width() == size.x && image.height() == size.y);
  if (codec.isLossless) {
    require(codec.decode(codec.encode(image, 0), size) == image);
  }
}

void decodeDepth(const DepthCodec& codec, std::span<const std::byte> bytes, const glm::ivec2& size) {
  const Image<uint16_t> image = codec.decode(bytes, size);
  require(codec.decode(codec.encode(image), size) == image);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  constexpr size_t kChoices = 3;
  if (size < kChoices) {
    return 0;
  }
  const size_t colors = colorCodecs().size();
  const size_t row = data[0] % (colors + depthCodecs().size());
  const glm::ivec2 expected(data[1], data[2]);
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size)).subspan(kChoices);
  try {
    if (row < colors) {
      if (colorCodecs()[row].name != kLeftOut) {
        decodeColor(colorCodecs()[row], bytes, expected);
      }
    } else if (depthCodecs()[row - colors].name != kLeftOut) {
      decodeDepth(depthCodecs()[row - colors], bytes, expected);
    }
  } catch (const InputError&) {
    // Any other exception is a finding.
  }
  return 0;
}
