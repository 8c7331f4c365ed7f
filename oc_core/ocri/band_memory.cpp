#include "oc_core/ocri/band_memory.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// How far from where it should be a silhouette is found again, pixels: those of curved surfaces glide along them.
constexpr int kReachPixels = 3;
/// A silhouette is the same where 1/z of its occluder differs by no more than this share of the step behind it.
constexpr float kSameDepth = 0.5f;

glm::ivec2 pixelOf(const glm::vec2& position) {
  return {static_cast<int>(std::floor(position.x)), static_cast<int>(std::floor(position.y))};
}

}  // namespace

BandMemory::Recalled BandMemory::recall(const PinholeCamera& camera, const std::vector<DistortionSplat>& splats) const {
  struct Moved {
    glm::vec2 position{0};
    float inverseNear = 0;
    float kept = 1;
  };
  // One for each pixel: the nearest to the eye.
  Image<Moved> moved(camera.width(), camera.height());
  for (const Band& band : bands_) {
    const std::optional<ImagePoint> q = camera.project(band.occluder);
    if (!q) {
      continue;
    }
    const glm::ivec2 pixel = pixelOf({q->u, q->v});
    if (moved.contains(pixel.x, pixel.y) && 1 / q->t > moved(pixel.x, pixel.y).inverseNear) {
      moved(pixel.x, pixel.y) = {{q->u, q->v}, 1 / q->t, band.kept};
    }
  }

  Recalled recalled{std::vector<float>(splats.size(), 1.0f), 0};
  std::vector<char> isKnown(splats.size(), 0);
  parallelFor(splats.size(), 256, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const DepthEdge& edge = splats[i].edge;
      const float tolerance = kSameDepth * (edge.inverseNear - edge.inverseFar);
      const glm::ivec2 pixel = pixelOf(edge.position);
      float nearest = static_cast<float>(kReachPixels);
      for (int y = pixel.y - kReachPixels; y <= pixel.y + kReachPixels; ++y) {
        for (int x = pixel.x - kReachPixels; x <= pixel.x + kReachPixels; ++x) {
          if (!moved.contains(x, y) || moved(x, y).inverseNear == 0) {
            continue;
          }
          const Moved& other = moved(x, y);
          const float distance = glm::distance(other.position, edge.position);
          if (distance < nearest && std::abs(other.inverseNear - edge.inverseNear) <= tolerance) {
            nearest = distance;
            recalled.kept[i] = other.kept;
            isKnown[i] = 1;
          }
        }
      }
    }
  });
  recalled.known = static_cast<size_t>(std::count(isKnown.begin(), isKnown.end(), 1));
  return recalled;
}

void BandMemory::remember(const PinholeCamera& camera, const std::vector<DistortionSplat>& splats,
                          const std::vector<float>& kept) {
  OC_CHECK(kept.size() == splats.size(), "each splat keeps a share of its band");
  eye_ = camera.eye();
  bands_.clear();
  for (size_t i = 0; i < splats.size(); ++i) {
    const DepthEdge& edge = splats[i].edge;
    if (const auto occluder = camera.unproject({edge.position.x, edge.position.y, 1 / edge.inverseNear})) {
      bands_.push_back({*occluder, kept[i]});
    }
  }
}

}  // namespace ocelli
