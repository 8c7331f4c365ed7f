// How the colour of a pixel is found where more than one surface, or an edge, shows in it.
#pragma once

#include <cstddef>
#include <memory>

#include "oc_core/antialiasing/sample_positions.h"

namespace ocelli {

struct PixelRule {
  std::shared_ptr<const SamplePattern> pattern;
  /// Multisampling: each triangle has one colour in a pixel, that at the pixel's middle. Otherwise each sample has its
  /// own.
  bool shadesAtMiddle = false;
  /// Pixels that at most so many triangles meet are averaged by area (pixel_area.h) instead.
  size_t maxExactTriangles = 0;
};

}  // namespace ocelli
