// What is in front of the background of one frame of a feed: connected regions, which are subjects or parts of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/image/png_file.h"

namespace ocelli {

/// One connected region of a feed that is not its background. Feed pixels.
struct SubjectBlob {
  glm::dvec2 lower{0};  ///< its box: the top left corner
  glm::dvec2 upper{0};
  glm::dvec2 foot{0};       ///< the middle of its lowest row
  bool isCutBelow = false;  ///< reaches the lower border of the image, so that its feet may be out of it
};

/// The side of a cell of the masks of a feed, in its pixels: so that a mask has at most 400 columns, and 200 at least
/// where the feed has 400; no cell is a pixel, which would be noise.
constexpr int maskScaleOf(int feedWidth) {
  constexpr int kMaxColumns = 400;
  return std::max(2, (feedWidth + kMaxColumns - 1) / kMaxColumns);
}

/// The subjects of one frame of a feed. A cell of the masks is maskScaleOf(its width) pixels of the feed a side; what
/// is left of a row or a column belongs to no cell. 0 is background, k is blob k - 1.
struct FeedBlobs {
  int scale = 2;
  std::vector<SubjectBlob> blobs;
  Image<uint16_t> core;  ///< what surely is a subject
  Image<uint16_t> wide;  ///< with its blurred rim: what is erased
  Image<Rgb8> colors;    ///< of the cells, in the light of the background; empty where they are not known
};

}  // namespace ocelli
