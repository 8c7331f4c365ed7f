// Images in files of other programs, as seas take them: PNG and JPEG.
//
// Recipe for a new format: a row of the table in oc_core/sea_input/image_file.cpp.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <string>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// Whether its ending is that of a format that can be read.
bool isImageFile(const std::filesystem::path& path);
/// Of an image, without reading all of it. Throws InputError for a file that is none.
glm::ivec2 imageFileSize(const std::filesystem::path& path);
/// Throws InputError for a file that is missing, none, damaged, or of another size, which it tells.
Image<Rgb8> readImageFile(const std::filesystem::path& path, const glm::ivec2& size);

}  // namespace ocelli
