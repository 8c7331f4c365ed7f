// 8-bit PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>

#include "oc_core/image/image.h"

namespace ocelli {

using Rgb8 = glm::vec<3, uint8_t>;

/// Throws WorkError where the file cannot be written in full.
void writePng(const std::filesystem::path& path, const Image<Rgb8>& image);
/// Reads any PNG as 8-bit RGB (grey and palette expanded, alpha dropped). Throws InputError.
Image<Rgb8> readPng(const std::filesystem::path& path);

/// sRGB-encodes a linear image.
Image<Rgb8> srgbFromLinear(const Image<glm::vec3>& linear);

}  // namespace ocelli
