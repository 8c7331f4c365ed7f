// The camera of a ray map (ray_map.h): each pixel centre has the ray that the map says, bent or not.
//
// Between pixel centres, rays are bilinear: with x_i(t) the point of the ray of neighbour i at parameter t, the ray of
// a position is x(t) = sum of w_i x_i(t), for the t that all neighbours have. A pinhole's rays, and those of all that
// displace its image linearly, are met exactly. From the outermost pixel centres to the border of the image the same
// goes on. Where a neighbour has no ray, or none that has a t in common, a position has the ray of its nearest pixel.
//
// project() solves x(u, v, t) = P within a quad of four neighbours; which quads can hold P is told by a hierarchy over
// the image (ray_map_search.h). Of several solutions that with the least t is taken: any cameras of anyone may see a
// point twice. Nothing is seen between neighbours without rays, and in images that are a pixel wide or high.
//
// There is no section of the text: the text's cameras all have projections. It is how they leave the toolkit.
#pragma once

#include <memory>

#include "oc_core/camera/camera.h"
#include "oc_core/camera/ray_map.h"

namespace ocelli {

class LazyRayMapSearch;

class RayMapCamera {
 public:
  /// Of an image of `size` pixels, which the map's are stretched over. The rays of the map must be in the world
  /// (RayMap::placedAt()).
  RayMapCamera(std::shared_ptr<const RayMap> map, const glm::ivec2& size);
  /// Of the map's own size.
  explicit RayMapCamera(const std::shared_ptr<const RayMap>& map);

  int width() const { return size_.x; }
  int height() const { return size_.y; }
  const RayMap& map() const { return *map_; }
  bool wrapsAround() const { return map_->notes().wrapsAround; }

  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const;
  /// The same without the hierarchy, from all quads one after the other: what project() is compared with.
  std::optional<ImagePoint> projectSlowly(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  /// Empty beyond the borders.
  RayPath rayPath(const glm::vec2& pixel) const;

 private:
  std::optional<ImagePoint> imagePoint(const std::optional<glm::dvec3>& found) const;

  std::shared_ptr<const RayMap> map_;
  glm::ivec2 size_;
  std::shared_ptr<const LazyRayMapSearch> search_;
};

static_assert(Camera<RayMapCamera>);

}  // namespace ocelli
