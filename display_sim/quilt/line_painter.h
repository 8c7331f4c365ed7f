// Draws lines of samples (sample_lines.h) as pinholes see them that have moved along the rows of the image: each in one
// dimension, with a depth at each pixel. One row of one view is a few hundred pixels, all of which stay in the fastest
// cache while all views of a row are drawn.
#pragma once

#include <cstddef>
#include <vector>

#include "display_sim/quilt/sample_lines.h"
#include "oc_core/image/png_file.h"
#include "oc_core/image/srgb_encoder.h"

namespace ocelli {

/// Where a view sees a point: x = perU u + perInverseZ / z + offset, in pixels of its tile.
struct LineMap {
  float perU = 1;
  float perInverseZ = 0;
  float offset = 0;
};

/// For one thread at a time.
class LinePainter {
 public:
  explicit LinePainter(int width);

  /// What is nearest at each pixel. Of what is equally near the first counts.
  void draw(const SampleLine& line, const LineMap& map);

  /// The colours of the line that was drawn last, a row of `lines`, and 1/z, as QuiltPicture has them; `inverseZ` may
  /// be nullptr. A pixel that the line says nothing of repeats the farther of the two next to its gap, or stays black
  /// where the lines do not know what is empty. Returns how many there are, but for those that repeat what is empty.
  size_t write(const SampleLine& line, const SampleLines& lines, const SrgbEncoder& encoder, Rgb8* color,
               float* inverseZ);

 private:
  size_t fillGaps(float emptyInverseZ, Rgb8* color) const;

  int width_;
  std::vector<float> x_;         ///< of the points of the line
  std::vector<float> inverseZ_;  ///< of each pixel
  std::vector<int> segment_;     ///< at each pixel: from which point to the next; -1 for none
};

}  // namespace ocelli
