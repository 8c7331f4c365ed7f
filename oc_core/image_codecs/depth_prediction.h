// What is left of 16-bit depths when each is predicted from its neighbours: mostly small numbers, which compress well.
//
// The prediction is the median edge detector of LOCO-I (Weinberger, Seroussi and Sapiro, 2000; JPEG-LS): with a to the
// left, b above and c above to the left, it is min(a, b) where c >= max(a, b), max(a, b) where c <= min(a, b), and
// a + b - c between. Values that are linear in 1/z are linear across the image of a plane, so there nothing is left but
// rounding; at edges one of the two sides is taken. Neighbours beyond the image are 0; in the first row b and c are, in
// the first column a and c.
//
// What is left, value - prediction modulo 65536, as a signed number r, is stored as 2 r where r >= 0 and -2 r - 1 where
// not: first the high bytes of all pixels in rows from the top, then the low bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/image/image.h"

namespace ocelli {

/// Two bytes a pixel.
std::vector<std::byte> depthResiduals(const Image<uint16_t>& image);
/// The other way. `residuals` has two bytes for each pixel: any bytes are those of some image.
Image<uint16_t> depthFromResiduals(std::span<const std::byte> residuals, glm::ivec2 size);

}  // namespace ocelli
