// Images that colour surfaces.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "oc_core/base/image.h"
#include "oc_core/base/png_file.h"

namespace ocelli {

enum class TextureWrap { kRepeat, kMirror, kClamp };

struct Texture {
  Image<Rgb8> image;  ///< sRGB
  TextureWrap wrapU = TextureWrap::kRepeat;
  TextureWrap wrapV = TextureWrap::kRepeat;

  /// The linear colour at `uv`, bilinearly interpolated. (0, 0) is the lower left corner of the image.
  glm::vec3 sample(const glm::vec2& uv) const;
  /// The same at half the size (rounded up), each pixel the mean of four in linear light.
  Texture halved() const;
};

/// Decodes PNG, JPEG, BMP, TGA or GIF. Throws InputError naming `where` for anything else, or more than 2^28 pixels.
Image<Rgb8> decodeImage(const std::vector<unsigned char>& bytes, const std::string& where);
Image<Rgb8> readImage(const std::filesystem::path& path);

}  // namespace ocelli
