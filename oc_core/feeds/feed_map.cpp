#include "oc_core/feeds/feed_map.h"

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

constexpr double kSteps = 1 << FeedPlace::kFractionBits;

int32_t fixedFrom(double pixels, int size) {
  return static_cast<int32_t>(std::lround(std::clamp(pixels - 0.5, 0.0, size - 1.0) * kSteps));
}

}  // namespace

FeedMap::FeedMap(const FeedGraph& graph)
    : width_(graph.camera().width()), height_(graph.camera().height()), coverage_(graph.frusta(), 0) {
  std::vector<size_t> shown(graph.frusta(), 0);
  std::vector<size_t> reached(graph.frusta(), 0);
  first_.reserve(static_cast<size_t>(width_) * static_cast<size_t>(height_) + 1);
  first_.push_back(0);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const glm::dvec2 pixel(x + 0.5, y + 0.5);
      std::vector<size_t> chain = graph.chainAt(pixel);
      ++shown[chain.back()];
      std::reverse(chain.begin(), chain.end());
      for (const size_t frustum : chain) {
        FeedPlace place;
        place.frustum = static_cast<uint16_t>(frustum);
        if (const auto found = graph.feedPixelAt(frustum, pixel)) {
          const Feed& feed = graph.feedOf(frustum);
          place.x = fixedFrom(found->x, feed.width);
          place.y = fixedFrom(found->y, feed.height);
          reached[frustum] += frustum == chain.front();
        }
        places_.push_back(place);
      }
      first_.push_back(static_cast<uint32_t>(places_.size()));
    }
  }
  for (size_t i = 0; i < coverage_.size(); ++i) {
    coverage_[i] = shown[i] > 0 ? static_cast<double>(reached[i]) / static_cast<double>(shown[i]) : 0;
  }
}

}  // namespace ocelli
