// What every slicer is told.
#pragma once

namespace ocelli {

enum class ColorReduction {
  kDither,     ///< ordered dithering to the levels of the display
  kOccupancy,  ///< a channel has full light where it has any light
};

struct SliceOptions {
  ColorReduction colors = ColorReduction::kDither;
};

}  // namespace ocelli
