// The same bytes as srgbByteFromLinear() (color.h), some ten times faster: for pictures of millions of pixels.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace ocelli {

class SrgbEncoder {
 public:
  /// Takes a while to make: keep it.
  SrgbEncoder();

  uint8_t byteFromLinear(float linear) const {
    if (!(linear > 0)) {
      return 0;
    }
    if (linear >= 1) {
      return 255;
    }
    // The byte at the lower end of the bin, which holds one step at the most.
    const uint8_t byte = byteOfBin_[static_cast<size_t>(linear * kBins)];
    return static_cast<uint8_t>(byte + (linear >= nextFrom_[byte] ? 1 : 0));
  }
  glm::vec<3, uint8_t> bytesFromLinear(const glm::vec3& linear) const {
    return {byteFromLinear(linear.x), byteFromLinear(linear.y), byteFromLinear(linear.z)};
  }

 private:
  static constexpr int kBins = 8192;
  std::array<uint8_t, kBins> byteOfBin_{};
  std::array<float, 256> nextFrom_{};  ///< the least linear value that has the next byte
};

}  // namespace ocelli
