// PNG: of colours, and of depths whose high byte is red and whose low byte is green, so that a page reads them from a
// canvas.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

std::vector<std::byte> encodePng(const Image<Rgb8>& image, double quality);
/// Throws InputError as ColorCodec::decode.
Image<Rgb8> decodePng(std::span<const std::byte> bytes, glm::ivec2 expectedSize);

std::vector<std::byte> encodePngDepth(const Image<uint16_t>& image);
Image<uint16_t> decodePngDepth(std::span<const std::byte> bytes, glm::ivec2 expectedSize);

}  // namespace ocelli
