// Images that colour surfaces.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// The most pixels that a texture may have.
inline constexpr uint64_t kMaxTexturePixels = uint64_t{1} << 28U;

enum class TextureWrap : uint8_t { kRepeat, kMirror, kClamp };

struct Texture {
  Image<Rgb8> image;  ///< sRGB
  TextureWrap wrapU = TextureWrap::kRepeat;
  TextureWrap wrapV = TextureWrap::kRepeat;

  /// The linear colour at `uv`, bilinearly interpolated. (0, 0) is the lower left corner of the image.
  glm::vec3 sample(const glm::vec2& uv) const;
  /// The same of an image whose red is a value, 0 to 255 for 0 to 1, as of a mask.
  float value(const glm::vec2& uv) const;
  /// The same at half the size (rounded up), each pixel the mean of four in linear light.
  Texture halved() const;
  /// The same where pixels are values.
  Texture halvedValues() const;
};

}  // namespace ocelli
