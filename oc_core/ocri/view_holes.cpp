#include "oc_core/ocri/view_holes.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace ocelli {
namespace {

constexpr glm::vec3 kHoleColor(1, 0, 1);

/// Fills holes one by one: connected ones together.
class HoleFiller {
 public:
  explicit HoleFiller(ResampledView& view) : view_(view), state_(view.hole.width(), view.hole.height(), kKnown) {
    for (size_t i = 0; i < state_.size(); ++i) {
      state_[i] = view.hole[i] != 0 ? kHole : kKnown;
    }
  }

  void fill() {
    for (size_t i = 0; i < state_.size(); ++i) {
      if (state_[i] == kHole) {
        fillFrom(i);
      }
    }
  }

 private:
  enum State : uint8_t { kKnown, kHole, kInHole, kFilled };

  template <class Visit>
  void around(size_t pixel, const Visit& visit) const {
    const auto width = static_cast<size_t>(view_.hole.width());
    const auto x = static_cast<int>(pixel % width);
    const auto y = static_cast<int>(pixel / width);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if ((dx != 0 || dy != 0) && state_.contains(x + dx, y + dy)) {
          visit(state_.index(x + dx, y + dy));
        }
      }
    }
  }

  /// 0 where nothing is seen: infinitely far away.
  float inverseDepth(size_t pixel) const { return view_.t[pixel] > 0 ? 1 / view_.t[pixel] : 0; }

  void fillFrom(size_t first) {
    std::vector<size_t> pixels{first};
    state_[first] = kInHole;
    float nearest = 0;
    float farthest = std::numeric_limits<float>::max();
    for (size_t i = 0; i < pixels.size(); ++i) {
      around(pixels[i], [&](size_t beside) {
        if (state_[beside] == kHole) {
          state_[beside] = kInHole;
          pixels.push_back(beside);
        } else if (state_[beside] == kKnown) {
          nearest = std::max(nearest, inverseDepth(beside));
          farthest = std::min(farthest, inverseDepth(beside));
        }
      });
    }
    // What is much nearer than the farthest hid what the hole shows.
    constexpr float kBehind = 0.3f;  // of the way (in 1/z) to the nearest
    const float limit = farthest + kBehind * (nearest - farthest);
    const auto isSource = [&](size_t pixel) {
      return state_[pixel] == kFilled || (state_[pixel] == kKnown && inverseDepth(pixel) <= limit);
    };
    std::vector<size_t> ring;
    for (const size_t pixel : pixels) {
      bool isRim = false;
      around(pixel, [&](size_t beside) { isRim = isRim || isSource(beside); });
      if (isRim) {
        ring.push_back(pixel);
      }
    }
    while (!ring.empty()) {
      ring = fillRing(ring, isSource);
    }
  }

  /// Averages of the sources around, all at once; returns the next ring.
  template <class IsSource>
  std::vector<size_t> fillRing(const std::vector<size_t>& ring, const IsSource& isSource) {
    std::vector<glm::vec3> colors;
    for (const size_t pixel : ring) {
      glm::vec3 sum(0);
      float count = 0;
      around(pixel, [&](size_t beside) {
        if (isSource(beside)) {
          sum += view_.color[beside];
          ++count;
        }
      });
      colors.push_back(sum / count);
    }
    for (size_t i = 0; i < ring.size(); ++i) {
      view_.color[ring[i]] = colors[i];
      state_[ring[i]] = kFilled;
    }
    std::vector<size_t> next;
    for (const size_t pixel : ring) {
      around(pixel, [&](size_t beside) {
        if (state_[beside] == kInHole) {
          next.push_back(beside);
        }
      });
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    return next;
  }

  ResampledView& view_;
  Image<uint8_t> state_;
};

}  // namespace

void markHoles(ResampledView& view) {
  for (size_t i = 0; i < view.hole.size(); ++i) {
    view.color[i] = view.hole[i] != 0 ? kHoleColor : view.color[i];
  }
}

void fillHoles(ResampledView& view) {
  HoleFiller(view).fill();
}

}  // namespace ocelli
