#include "oc_core/image_codecs/codec_error.h"

#include <fmt/format.h>

#include "oc_core/base/error.h"
#include "oc_core/image_codecs/image_codec.h"

namespace ocelli {

void failDecoding(const char* codec, const std::string& problem) {
  throw InputError(fmt::format("these bytes are not a whole {} image ({})", codec, problem), "coded image",
                   "send or make it again");
}

void checkExpectedSize(const char* codec, const glm::ivec2& expectedSize) {
  const auto [width, height] = std::pair(int64_t{expectedSize.x}, int64_t{expectedSize.y});
  if (width < 1 || height < 1 || width > kMaxCodedSide || height > kMaxCodedSide || width * height > kMaxCodedPixels) {
    failDecoding(codec, fmt::format("an image has from 1 to {} pixels, at most {} a side, and not {} x {}",
                                    kMaxCodedPixels, kMaxCodedSide, width, height));
  }
}

void checkDecodedSize(const char* codec, int64_t width, int64_t height, const glm::ivec2& expectedSize) {
  if (width != expectedSize.x || height != expectedSize.y) {
    failDecoding(codec,
                 fmt::format("it is of {} x {} pixels, not {} x {}", width, height, expectedSize.x, expectedSize.y));
  }
}

}  // namespace ocelli
