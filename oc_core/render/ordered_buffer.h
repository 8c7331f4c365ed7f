// The closest sample at each pixel along rays of several pieces: a ray meets what its first piece holds before anything
// that later ones do, so samples are ordered by the piece first, and then as those of the visibility buffer.
#pragma once

#include "oc_core/render/visibility_buffer.h"

namespace ocelli {

class OrderedBuffer {
 public:
  static constexpr uint8_t kNone = 0xff;

  explicit OrderedBuffer(size_t pixels) : orders_(pixels, kNone), samples_(pixels) {}

  /// `depth` is positive and grows along the piece.
  void put(size_t pixel, uint8_t order, float depth, uint32_t triangle, const glm::vec2& b) {
    orders_[pixel] = order;
    samples_[pixel] = {KeyedSample::keyOf(depth, triangle), b.x, b.y};
  }

  /// The piece that the sample lies in; kNone where there is none.
  uint8_t order(size_t pixel) const { return orders_[pixel]; }
  const KeyedSample& sample(size_t pixel) const { return samples_[pixel]; }
  Fragment fragment(size_t pixel) const { return samples_[pixel].fragment(); }

 private:
  std::vector<uint8_t> orders_;
  std::vector<KeyedSample> samples_;
};

}  // namespace ocelli
