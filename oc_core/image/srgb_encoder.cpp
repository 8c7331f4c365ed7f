#include "oc_core/image/srgb_encoder.h"

#include <bit>
#include <limits>

#include "oc_core/image/color.h"

namespace ocelli {
namespace {

/// The least float of [0, 1] whose byte is above `byte`. Positive floats are in the order of their bits.
float firstAbove(uint8_t byte) {
  uint32_t below = 0;
  uint32_t above = std::bit_cast<uint32_t>(1.0f);
  while (above - below > 1) {
    const uint32_t middle = below + (above - below) / 2;
    (srgbByteFromLinear(std::bit_cast<float>(middle)) > byte ? above : below) = middle;
  }
  return std::bit_cast<float>(above);
}

}  // namespace

SrgbEncoder::SrgbEncoder() {
  for (size_t byte = 0; byte < 255; ++byte) {
    nextFrom_[byte] = firstAbove(static_cast<uint8_t>(byte));
  }
  nextFrom_[255] = std::numeric_limits<float>::infinity();
  for (size_t bin = 0; bin < byteOfBin_.size(); ++bin) {
    byteOfBin_[bin] = srgbByteFromLinear(static_cast<float>(bin) / kBins);
  }
}

}  // namespace ocelli
