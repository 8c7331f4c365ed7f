#include <algorithm>

#include "oc_core/antialiasing/antialias_regions.h"
#include "oc_core/base/disjoint_sets.h"

namespace ocelli {

std::vector<PixelBounds> denseRectangles(const AntialiasScene& scene, double dense) {
  constexpr int kBlock = AntialiasBins::kBlock;
  const AntialiasBins& bins = scene.bins();
  const auto indexOf = [&](int x, int y) { return static_cast<size_t>(y * bins.across() + x); };
  const auto isDense = [&](int x, int y) {
    return static_cast<double>(bins.trianglesOf(indexOf(x, y)).size()) > dense * kBlock * kBlock;
  };
  DisjointSets groups(bins.blocks());
  for (int y = 0; y < bins.down(); ++y) {
    for (int x = 0; x < bins.across(); ++x) {
      if (!isDense(x, y)) {
        continue;
      }
      // The neighbours that have been seen before, those at a corner too.
      for (const glm::ivec2 step : {glm::ivec2(-1, 0), {-1, -1}, {0, -1}, {1, -1}}) {
        const glm::ivec2 other = glm::ivec2(x, y) + step;
        if (other.x >= 0 && other.y >= 0 && other.x < bins.across() && isDense(other.x, other.y)) {
          groups.join(static_cast<uint32_t>(indexOf(x, y)), static_cast<uint32_t>(indexOf(other.x, other.y)));
        }
      }
    }
  }
  std::vector<PixelBounds> boxOf(bins.blocks(), {scene.view().width(), scene.view().height(), 0, 0});
  for (int y = 0; y < bins.down(); ++y) {
    for (int x = 0; x < bins.across(); ++x) {
      if (isDense(x, y)) {
        PixelBounds& box = boxOf[groups.least(static_cast<uint32_t>(indexOf(x, y)))];
        box.x0 = std::min(box.x0, x * kBlock);
        box.y0 = std::min(box.y0, y * kBlock);
        box.x1 = std::max(box.x1, std::min((x + 1) * kBlock, scene.view().width()));
        box.y1 = std::max(box.y1, std::min((y + 1) * kBlock, scene.view().height()));
      }
    }
  }
  std::erase_if(boxOf, [](const PixelBounds& box) { return box.x0 >= box.x1; });
  return boxOf;
}

}  // namespace ocelli
