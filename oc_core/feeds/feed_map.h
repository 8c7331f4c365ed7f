// Which pixels of which feeds make each pixel of the composed image: made once, read for every frame.
//
// A pixel has one place in the feed of each frustum that its ray passes: the last one is what it shows, those before it
// show subjects that stand before the near face of the next. Places are in fixed point, for bilinear samples.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/feeds/feed_graph.h"

namespace ocelli {

/// A place in a feed, in 1/256 pixel from the middle of its first pixel.
struct FeedPlace {
  static constexpr int kFractionBits = 8;
  static constexpr int32_t kNowhere = -1;

  uint16_t frustum = 0;
  int32_t x = kNowhere;  ///< kNowhere where the feed does not reach
  int32_t y = kNowhere;

  bool isInFeed() const { return x != kNowhere; }
};

class FeedMap {
 public:
  explicit FeedMap(const FeedGraph& graph);

  int width() const { return width_; }
  int height() const { return height_; }
  /// From the frustum that the pixel shows back to the root.
  std::span<const FeedPlace> placesAt(size_t pixel) const {
    return {places_.data() + first_[pixel], first_[pixel + 1] - first_[pixel]};
  }
  /// The share of the pixels of a frustum's part of the image that its feed reaches.
  double coverage(size_t frustum) const { return coverage_[frustum]; }

 private:
  int width_;
  int height_;
  std::vector<uint32_t> first_;
  std::vector<FeedPlace> places_;
  std::vector<double> coverage_;
};

}  // namespace ocelli
