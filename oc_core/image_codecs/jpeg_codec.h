// JPEG with libjpeg: progressive or baseline, whole colours from a quality on, below which chroma is halved.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// `quality` is that of libjpeg. Below kJpegWholeChroma chroma has half the resolution (4:2:0).
inline constexpr double kJpegWholeChroma = 85;
std::vector<std::byte> encodeJpeg(const Image<Rgb8>& image, double quality);
/// Not progressive: it is decoded in a third of the time, and takes about as many bytes.
std::vector<std::byte> encodeBaselineJpeg(const Image<Rgb8>& image, double quality);
/// Throws InputError as ColorCodec::decode; for data that libjpeg warns of, too.
Image<Rgb8> decodeJpeg(std::span<const std::byte> bytes, glm::ivec2 expectedSize);

}  // namespace ocelli
