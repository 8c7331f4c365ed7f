// Pixels as planes of raw video: colours as 10 bits, 4:2:0, BT.709 of narrow range, and depths as 16 bits of 1/z.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "oc_core/miv/miv_sequence.h"

namespace ocelli {

/// How many bytes a frame has: 16 bits a sample, 1.5 samples a pixel.
size_t mivFrameBytes(int width, int height);

/// Y, Cb, Cr. Chroma is the mean of 2x2 pixels.
std::string mivTextureBytes(const Image<glm::vec3>& linearColor);
/// Linear colours; chroma is that of its 2x2 pixels. `bytes` has a frame of this size. Values outside of 10 bits are
/// taken for what they say.
Image<glm::vec3> colorsOfMivTexture(std::string_view bytes, int width, int height);

/// Level 0 is nothing; 1 to 65535 are equal steps of 1/z from far to near.
std::string mivDepthBytes(const Image<float>& depth, const MivDepthRange& range, double unitsPerMetre);
Image<float> depthsOfMivDepth(std::string_view bytes, int width, int height, const MivDepthRange& range,
                              double unitsPerMetre);

}  // namespace ocelli
