#include "oc_core/image/color.h"

#include <array>
#include <cmath>

namespace ocelli {
namespace {

std::array<float, 256> makeByteTable() {
  std::array<float, 256> table{};
  for (size_t i = 0; i < table.size(); ++i) {
    table[i] = linearFromSrgb(static_cast<float>(i) / 255.0f);
  }
  return table;
}

}  // namespace

float linearFromSrgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float srgbFromLinear(float linear) {
  return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

glm::vec3 linearFromSrgb(const glm::vec3& encoded) {
  return {linearFromSrgb(encoded.x), linearFromSrgb(encoded.y), linearFromSrgb(encoded.z)};
}

uint8_t srgbByteFromLinear(float linear) {
  if (!(linear > 0)) {
    return 0;
  }
  return linear >= 1 ? 255 : static_cast<uint8_t>(std::lround(srgbFromLinear(linear) * 255.0f));
}

float linearFromSrgbByte(uint8_t encoded) {
  static const std::array<float, 256> table = makeByteTable();
  return table[encoded];
}

}  // namespace ocelli
