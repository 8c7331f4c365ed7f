// Depths as their residuals (depth_prediction.h) in a zlib stream (RFC 1950), which pages read with
// DecompressionStream("deflate").
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/image/image.h"

namespace ocelli {

std::vector<std::byte> encodeDeflateDepth(const Image<uint16_t>& image);
/// Throws InputError as DepthCodec::decode.
Image<uint16_t> decodeDeflateDepth(std::span<const std::byte> bytes, glm::ivec2 expectedSize);

}  // namespace ocelli
