// PNG files of one channel of 16 bits, whose levels are numbers and no light: depths.
#pragma once

#include <cstdint>
#include <filesystem>

#include "oc_core/image/image.h"

namespace ocelli {

/// Throws WorkError where the file cannot be written in full.
void writeLevelPng(const std::filesystem::path& path, const Image<uint16_t>& levels);

/// The levels as they stand in the file, whatever it says of gamma and colour profiles. Throws InputError where it is
/// missing, broken, larger than 2^26 pixels, or no grey PNG of 16 bits.
Image<uint16_t> readLevelPng(const std::filesystem::path& path);

}  // namespace ocelli
