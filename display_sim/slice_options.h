// What every slicer is told.
#pragma once

namespace ocelli {

enum class ColorReduction {
  kDither,     ///< ordered dithering to the levels of the display
  kOccupancy,  ///< a channel has full light where it has any light
};

struct SliceOptions {
  ColorReduction colors = ColorReduction::kDither;
  /// A sample between two slices lights both, in proportion to how near it is.
  bool angularAntialiasing = false;
};

}  // namespace ocelli
