// Hybrid ray casting (section 6.1.3.1): triangle by triangle, as a rasteriser works, but every pixel of a conservative
// footprint decides by intersecting its own ray path. Neither an acceleration structure of the scene nor subdivision is
// needed, and the image is that of ray casting.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "oc_core/base/parallel.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/render/image_footprint.h"

namespace ocelli {

/// The ray paths of all pixel centres of a camera, kept in the camera space of its reference pinhole, where z grows
/// along each of them.
class RayPathTable {
 public:
  template <BoundedCamera C>
  explicit RayPathTable(const C& camera)
      : RayPathTable(camera.width(), camera.height(), referenceOf(camera),
                     [&](const glm::vec2& pixel) { return camera.rayPath(pixel); }) {}

  int width() const { return width_; }
  int height() const { return height_; }

  struct Meeting {
    float z = 0;
    float b1 = 0;
    float b2 = 0;
  };
  /// Where the path of a pixel first meets a triangle (in the same camera space), its edges included.
  std::optional<Meeting> meet(size_t pixel, const std::array<glm::vec3, 3>& triangle) const;

 private:
  RayPathTable(int width, int height, const PinholeCamera& reference,
               const std::function<RayPath(const glm::vec2& pixel)>& rayPath);

  int width_;
  int height_;
  std::vector<size_t> firstPoint_;  ///< of each pixel, in row order, and one more
  std::vector<glm::vec3> points_;
};

/// The closest of all triangles at each pixel; the lower triangle index on a tie. `cornersOf(triangle)` gives a
/// triangle in the camera space of `paths`, `footprintOf(corners)` the pixels that may see it.
FragmentImage castTriangles(const RayPathTable& paths, size_t triangleCount,
                            const std::function<std::array<glm::vec3, 3>(size_t triangle)>& cornersOf,
                            const std::function<PixelBox(const std::array<glm::vec3, 3>& corners)>& footprintOf);

template <BoundedCamera C>
FragmentImage hybridRaycast(const C& camera, const Mesh& mesh, const RayPathTable& paths) {
  const PinholeCamera& reference = referenceOf(camera);
  return castTriangles(
      paths, mesh.triangles.size(),
      [&](size_t i) {
        const glm::uvec3& t = mesh.triangles[i];
        return std::array{reference.cameraFromWorld(mesh.positions[t.x]),
                          reference.cameraFromWorld(mesh.positions[t.y]),
                          reference.cameraFromWorld(mesh.positions[t.z])};
      },
      [&](const std::array<glm::vec3, 3>& corners) { return footprint(camera, corners); });
}
template <BoundedCamera C>
FragmentImage hybridRaycast(const C& camera, const Mesh& mesh) {
  return hybridRaycast(camera, mesh, RayPathTable(camera));
}

}  // namespace ocelli
