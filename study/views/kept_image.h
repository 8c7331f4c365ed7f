// An image of an observer as it is kept in memory, small enough for hundreds of them: the pixels of what is lit, and
// the objects in two bytes a pixel.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "study/task/trial_layout.h"

namespace ocelli {

class KeptImage {
 public:
  /// `objects` is as identity_image.h, of the same size.
  KeptImage(const Image<Rgb8>& pixels, const Image<uint32_t>& objects);

  size_t bytes() const;
  /// As large as `size`: the same bytes where that is the size of the image, else interpolated between the light of the
  /// four pixels around; objects are those of the nearest pixel. Without positions of objects.
  ShownImage at(const glm::ivec2& size) const;

 private:
  glm::ivec2 size_;            ///< of the whole image
  glm::ivec2 corner_{};        ///< of what is kept, in the image
  Image<Rgb8> pixels_;         ///< black beyond
  Image<uint16_t> objects_{};  ///< of these pixels; 0 where there is nothing, else one more than their identity
};

}  // namespace ocelli
