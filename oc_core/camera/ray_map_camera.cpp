#include "oc_core/camera/ray_map_camera.h"

#include <cmath>
#include <glm/common.hpp>
#include <mutex>
#include <tuple>

#include "oc_core/base/check.h"
#include "oc_core/base/finite.h"
#include "oc_core/camera/ray_map_quad.h"
#include "oc_core/camera/ray_map_search.h"

namespace ocelli {
namespace {

/// (u, v, t) in pixels of the map, from the quads of a rectangle; the one with the least t of `best` and these.
void solveQuads(const RayMap& map, const glm::ivec2& lower, const glm::ivec2& upper, const glm::dvec3& point,
                std::optional<glm::dvec3>& best) {
  // Of the same t, which neighbouring quads give for a point between them, the upper and left one.
  const auto order = [](const glm::dvec3& q) { return std::tuple(q.z, q.y, q.x); };
  for (int y = lower.y; y < upper.y; ++y) {
    for (int x = lower.x; x < upper.x; ++x) {
      const RayMapQuad quad(map, x, y);
      if (!quad.whole()) {
        continue;
      }
      const QuadReach reach = reachOf(map, {x, y});
      if (const std::optional<glm::dvec3> found = quad.solve(point, reach.lower, reach.upper)) {
        glm::dvec3 q(x + 0.5 + found->x, y + 0.5 + found->y, found->z);
        if (map.notes().wrapsAround && q.x > map.width()) {
          q.x -= map.width();
        }
        if (!best || order(q) < order(*best)) {
          best = q;
        }
      }
    }
  }
}

/// Of a pixel of an image of that size; nothing beyond its borders.
std::optional<QuadPosition> quadPositionIn(const RayMap& map, const glm::ivec2& size, const glm::vec2& pixel) {
  if (!(pixel.x >= 0 && pixel.x <= static_cast<float>(size.x) && pixel.y >= 0 &&
        pixel.y <= static_cast<float>(size.y))) {
    return std::nullopt;
  }
  const glm::dvec2 mapSize(map.width(), map.height());
  return quadPosition(map, glm::min(glm::dvec2(pixel) * (mapSize / glm::dvec2(size)), mapSize));
}

}  // namespace

/// Made when it is first asked for: most cameras of maps only give rays.
class LazyRayMapSearch {
 public:
  const RayMapSearch& of(const RayMap& map) const {
    std::call_once(made_, [&] { search_ = std::make_unique<const RayMapSearch>(map); });
    return *search_;
  }

 private:
  mutable std::once_flag made_;
  mutable std::unique_ptr<const RayMapSearch> search_;
};

RayMapCamera::RayMapCamera(std::shared_ptr<const RayMap> map, const glm::ivec2& size)
    : map_(std::move(map)), size_(size), search_(std::make_shared<const LazyRayMapSearch>()) {
  OC_CHECK(map_->notes().frame == RayFrame::kWorld, "a camera's rays are in the world");
  OC_CHECK(size.x > 0 && size.y > 0, "an image has pixels");
}

RayMapCamera::RayMapCamera(const std::shared_ptr<const RayMap>& map)
    : RayMapCamera(map, glm::ivec2(map->width(), map->height())) {}

std::optional<ImagePoint> RayMapCamera::imagePoint(const std::optional<glm::dvec3>& found) const {
  if (!found) {
    return std::nullopt;
  }
  const glm::dvec2 scale = glm::dvec2(size_) / glm::dvec2(map_->width(), map_->height());
  return ImagePoint{static_cast<float>(found->x * scale.x), static_cast<float>(found->y * scale.y),
                    static_cast<float>(found->z)};
}

std::optional<ImagePoint> RayMapCamera::project(const glm::vec3& worldPoint) const {
  if (!isFinite(worldPoint)) {
    return std::nullopt;
  }
  const glm::dvec3 point(worldPoint);
  std::optional<glm::dvec3> best;
  for (const glm::ivec2& block : search_->of(*map_).blocksNear(point)) {
    const glm::ivec2 lower = block * RayMapSearch::kBlockSide;
    solveQuads(*map_, lower, glm::min(lower + RayMapSearch::kBlockSide, quadCount(*map_)), point, best);
  }
  return imagePoint(best);
}

std::optional<ImagePoint> RayMapCamera::projectSlowly(const glm::vec3& worldPoint) const {
  std::optional<glm::dvec3> best;
  if (isFinite(worldPoint)) {
    solveQuads(*map_, {0, 0}, quadCount(*map_), glm::dvec3(worldPoint), best);
  }
  return imagePoint(best);
}

std::optional<glm::vec3> RayMapCamera::unproject(const ImagePoint& q) const {
  const std::optional<QuadPosition> at = quadPositionIn(*map_, size_, {q.u, q.v});
  if (!at || !std::isfinite(q.t)) {
    return std::nullopt;
  }
  const auto within = [&](const auto& rays) {
    return q.t >= static_cast<float>(rays.tMin()) && q.t <= static_cast<float>(rays.tMax());
  };
  const RayMapQuad quad(*map_, at->quad.x, at->quad.y);
  if (!at->onPixel && quad.whole()) {
    return within(quad) ? std::optional(glm::vec3(quad.pointAt(at->ab, static_cast<double>(q.t)))) : std::nullopt;
  }
  const RayMapRay ray = map_->ray(at->nearest.x, at->nearest.y);
  if (ray.empty() || !within(ray)) {
    return std::nullopt;
  }
  const RayPath path = ray.path();
  return path.pointAt(path.positionAt(q.t));
}

RayPath RayMapCamera::rayPath(const glm::vec2& pixel) const {
  const std::optional<QuadPosition> at = quadPositionIn(*map_, size_, pixel);
  if (!at) {
    return {};
  }
  if (!at->onPixel) {
    if (const RayMapQuad quad(*map_, at->quad.x, at->quad.y); quad.whole()) {
      return quad.pathAt(at->ab);
    }
  }
  return map_->ray(at->nearest.x, at->nearest.y).path();
}

}  // namespace ocelli
