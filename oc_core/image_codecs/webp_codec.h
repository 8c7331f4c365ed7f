// WebP with libwebp: lossy, lossless, and depths in lossless images.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// `quality` is that of libwebp. Chroma has half the resolution, chosen such that edges stay sharp ("sharp YUV").
std::vector<std::byte> encodeWebp(const Image<Rgb8>& image, double quality);
std::vector<std::byte> encodeLosslessWebp(const Image<Rgb8>& image, double quality);
/// Of both. Throws InputError as ColorCodec::decode.
Image<Rgb8> decodeWebp(std::span<const std::byte> bytes, glm::ivec2 expectedSize);

/// The residuals of depths (depth_prediction.h) as colours: the low byte in green, the high byte in red, no blue.
std::vector<std::byte> encodeWebpDepth(const Image<uint16_t>& image);
Image<uint16_t> decodeWebpDepth(std::span<const std::byte> bytes, glm::ivec2 expectedSize);

}  // namespace ocelli
