// Images as residuals in a zstd frame: of depths those of depth_prediction.h, of colours the same prediction for each
// of the channels G, R - G and B - G, which lie in planes, a byte a pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

std::vector<std::byte> encodeZstd(const Image<Rgb8>& image, double quality);
/// Throws InputError as ColorCodec::decode.
Image<Rgb8> decodeZstd(std::span<const std::byte> bytes, glm::ivec2 expectedSize);

std::vector<std::byte> encodeZstdDepth(const Image<uint16_t>& image);
Image<uint16_t> decodeZstdDepth(std::span<const std::byte> bytes, glm::ivec2 expectedSize);

}  // namespace ocelli
