// The AprilTags (family 36h11; Olson 2011, Wang and Olson 2016) that an image shows.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/image/png_file.h"

namespace ocelli {

struct SeenTag {
  int id = 0;
  /// Corners of the black border as it is printed upright: top left, top right, bottom right, bottom left. Pixels from
  /// the top left corner of the image.
  std::array<glm::dvec2, 4> corners{};
};

/// By id; a tag that is seen twice is left out, because nobody knows which one is meant.
std::vector<SeenTag> tagsIn(const Image<Rgb8>& image);

/// The means of the corners over several images of the same view: tags that half of them or more show.
std::vector<SeenTag> meanTags(const std::vector<std::vector<SeenTag>>& images);

}  // namespace ocelli
