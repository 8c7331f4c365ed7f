// Images to encode, with what images of scenes have: slopes, edges and nothing at all.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli::test {

/// A smooth background with a disc of another colour.
Image<Rgb8> coloredDisc(int width, int height);
/// Every byte any value.
Image<Rgb8> colorNoise(int width, int height);

/// A plane, linear in the image, with a nearer disc; nothing in the lower left corner.
Image<uint16_t> depthOfDisc(int width, int height);
/// Every value from 0 to 65535 may stand anywhere.
Image<uint16_t> depthNoise(int width, int height);

}  // namespace ocelli::test
