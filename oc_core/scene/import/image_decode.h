// Image files that colour surfaces, decoded by stb_image.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "oc_core/image/png_file.h"

namespace ocelli {

/// Called before so many bytes are asked for, which the size of a compressed file does not tell of.
using MemoryNotice = std::function<void(uint64_t bytes)>;

/// Decodes PNG, JPEG, BMP, TGA, GIF and whatever else stb_image knows. Throws InputError naming `where` for anything
/// else, and for more than kMaxTexturePixels.
Image<Rgb8> decodeImage(std::span<const unsigned char> bytes, const std::string& where,
                        const MemoryNotice& notice = {});
/// The transparency of such an image as its red, green and blue: 255 where it hides what lies behind. Where the image
/// has none, its brightness if `orBrightness`, otherwise nothing. Throws as decodeImage() does.
std::optional<Image<Rgb8>> decodeOpacity(std::span<const unsigned char> bytes, bool orBrightness,
                                         const std::string& where, const MemoryNotice& notice = {});
/// The bytes of a file, which is read where it is a regular one of at most 2 GiB.
std::string readImageBytes(const std::filesystem::path& path, const MemoryNotice& notice = {});
/// The image that these are.
Image<Rgb8> readImage(const std::filesystem::path& path, const MemoryNotice& notice = {});

}  // namespace ocelli
