// The rays of the pixels of an image, cast tile by tile: neighbours run alike, and are cast together. For .cpp files.
#pragma once

#include <algorithm>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "oc_core/base/parallel.h"
#include "oc_core/camera/ray_path.h"
#include "oc_core/image/image.h"

namespace ocelli {

/// Whether a tile, from `lower` to `upper` in pixels, is cast; where not, its pixels are Result{}. Empty: all are.
using TileFilter = std::function<bool(const glm::vec2& lower, const glm::vec2& upper)>;

/// The first pixel of a tile, and the one behind its last.
using TileRays = std::function<void(const glm::ivec2& first, const glm::ivec2& end, std::vector<RayPath>& rays)>;

/// `makeRays` adds the rays of the pixels of a tile, row by row, or none, and its pixels are Result{}. `cast(rays,
/// results)` gets them, and room for their results. On all threads.
template <class Result, class Cast>
Image<Result> castTiles(int width, int height, const TileRays& makeRays, const Cast& cast) {
  constexpr int kTile = 8;  ///< pixels a side
  Image<Result> image(width, height);
  const int across = (width + kTile - 1) / kTile;
  const int down = (height + kTile - 1) / kTile;
  parallelFor(static_cast<size_t>(across) * static_cast<size_t>(down), 4, [&](size_t begin, size_t end) {
    std::vector<RayPath> rays;
    std::vector<Result> results(kTile * kTile);
    for (size_t tile = begin; tile < end; ++tile) {
      const int x0 = static_cast<int>(tile) % across * kTile;
      const int y0 = static_cast<int>(tile) / across * kTile;
      const int x1 = std::min(x0 + kTile, width);
      const int y1 = std::min(y0 + kTile, height);
      rays.clear();
      makeRays({x0, y0}, {x1, y1}, rays);
      if (rays.empty()) {
        continue;
      }
      cast(std::span<const RayPath>(rays), std::span(results).first(rays.size()));
      auto next = results.begin();
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
          image(x, y) = *next++;
        }
      }
    }
  });
  return image;
}

/// The same, of a ray for each pixel.
template <class Result, class Cast>
Image<Result> castTiles(int width, int height, const std::function<RayPath(const glm::vec2& pixel)>& rayPath,
                        const Cast& cast, const TileFilter& isCast = {}) {
  return castTiles<Result>(
      width, height,
      [&](const glm::ivec2& first, const glm::ivec2& end, std::vector<RayPath>& rays) {
        if (isCast && !isCast(glm::vec2(first), glm::vec2(end))) {
          return;
        }
        for (int y = first.y; y < end.y; ++y) {
          for (int x = first.x; x < end.x; ++x) {
            rays.push_back(rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
          }
        }
      },
      cast);
}

}  // namespace ocelli
