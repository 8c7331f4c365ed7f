// Linear light to and from 8-bit sRGB (IEC 61966-2-1).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace ocelli {

float linearFromSrgb(float encoded);
float srgbFromLinear(float linear);
glm::vec3 linearFromSrgb(const glm::vec3& encoded);

/// Clamps to [0, 1], encodes, rounds to a byte. NaN gives 0.
uint8_t srgbByteFromLinear(float linear);
float linearFromSrgbByte(uint8_t encoded);

}  // namespace ocelli
