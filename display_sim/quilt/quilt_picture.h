// A quilt as it is drawn: its colours, and what of it is known.
#pragma once

#include <cstddef>

#include "display_sim/quilt/quilt_views.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

struct QuiltPicture {
  /// sRGB, as large as the display says; black where nothing is seen, and in what the tiles leave over.
  Image<Rgb8> color;
  /// 1/z of what each pixel shows, z along the view direction in lengths of the scene; 0 where nothing is seen, and
  /// where colours were filled in. Empty where it was not asked for.
  Image<float> inverseZ;
  /// Pixels of which nothing is known, but for those beside what is known to be empty. They repeat what lies beside
  /// them, the farther first; or are black, where it is not known what is empty.
  size_t filled = 0;

  /// Of the pixels of all tiles.
  double filledRatio(const QuiltViews& views) const {
    return static_cast<double>(filled) / static_cast<double>(views.display().tilePixels());
  }
};

enum class QuiltDepths { kNone, kKept };

inline QuiltPicture blankQuilt(const QuiltDisplay& display, QuiltDepths depths) {
  QuiltPicture picture;
  picture.color = Image<Rgb8>(display.width, display.height, Rgb8(0));
  if (depths == QuiltDepths::kKept) {
    picture.inverseZ = Image<float>(display.width, display.height, 0.0f);
  }
  return picture;
}

}  // namespace ocelli
