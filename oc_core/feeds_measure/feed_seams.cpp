#include "oc_core/feeds_measure/feed_seams.h"

#include <algorithm>
#include <cstdlib>

namespace ocelli {
namespace {

int jumpOf(const Image<Rgb8>& image, size_t a, size_t b) {
  int jump = 0;
  for (int c = 0; c < 3; ++c) {
    jump = std::max(jump, std::abs(static_cast<int>(image[a][c]) - static_cast<int>(image[b][c])));
  }
  return jump;
}

}  // namespace

SeamMeter::SeamMeter(const FeedMap& map) {
  const auto width = static_cast<size_t>(map.width());
  const auto shownBy = [&](size_t pixel) { return map.placesAt(pixel).front().frustum; };
  const auto look = [&](int x, int y, int dx, int dy) {
    if (x + dx >= map.width() || y + dy >= map.height()) {
      return;
    }
    const auto at = [&](int px, int py) { return static_cast<size_t>(py) * width + static_cast<size_t>(px); };
    if (shownBy(at(x, y)) == shownBy(at(x + dx, y + dy))) {
      return;
    }
    seams_.push_back({at(x, y), at(x + dx, y + dy)});
    for (const int side : {-kSeamInside, kSeamInside}) {
      const int px = x + side * dx;
      const int py = y + side * dy;
      const bool isInImage = px >= 0 && py >= 0 && px + dx < map.width() && py + dy < map.height();
      if (isInImage && shownBy(at(px, py)) == shownBy(at(px + dx, py + dy))) {
        inside_.push_back({at(px, py), at(px + dx, py + dy)});
      }
    }
  };
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      look(x, y, 1, 0);
      look(x, y, 0, 1);
    }
  }
}

FeedSeams SeamMeter::measure(const Image<Rgb8>& composed, const Image<Rgb8>& rendered) const {
  FeedSeams result;
  const auto excessOf = [&](const Pair& pair) {
    return std::max(0, jumpOf(composed, pair.a, pair.b) - jumpOf(rendered, pair.a, pair.b));
  };
  const auto meanOf = [](double sum, size_t count) { return count > 0 ? sum / static_cast<double>(count) : 0; };
  double sum = 0;
  for (const Pair& pair : seams_) {
    const int excess = excessOf(pair);
    sum += excess;
    result.visible += excess > kSeamLevels;
  }
  double inside = 0;
  for (const Pair& pair : inside_) {
    inside += excessOf(pair);
  }
  result.pairs = seams_.size();
  result.levels = meanOf(sum, seams_.size());
  result.insideLevels = meanOf(inside, inside_.size());
  return result;
}

FeedSeams meanSeams(const std::vector<FeedSeams>& frames) {
  FeedSeams mean;
  for (const FeedSeams& frame : frames) {
    mean.pairs += frame.pairs;
    mean.visible += frame.visible;
    mean.levels += frame.levels / static_cast<double>(frames.size());
    mean.insideLevels += frame.insideLevels / static_cast<double>(frames.size());
  }
  return mean;
}

}  // namespace ocelli
