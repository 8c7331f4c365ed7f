// JPEG XL with libjxl: of colours lossy, and lossless at a quality of 100; of depths lossless, one channel of 16 bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// `quality` as cjxl takes it.
std::vector<std::byte> encodeJxl(const Image<Rgb8>& image, double quality);
/// Throws InputError as ColorCodec::decode. Only still images of one frame, hidden ones included, without further
/// channels are taken: others could ask for more memory than the image. A profile of colours may still ask for some: as
/// much as libjxl takes.
Image<Rgb8> decodeJxl(std::span<const std::byte> bytes, glm::ivec2 expectedSize);

std::vector<std::byte> encodeJxlDepth(const Image<uint16_t>& image);
Image<uint16_t> decodeJxlDepth(std::span<const std::byte> bytes, glm::ivec2 expectedSize);

}  // namespace ocelli
