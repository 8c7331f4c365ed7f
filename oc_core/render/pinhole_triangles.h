// The triangles of a mesh as a planar pinhole camera sees them: vertices projected once, clipped where they have to be.
#pragma once

#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/render/visibility_buffer.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class PinholeTriangles {
 public:
  /// Both must outlive it.
  PinholeTriangles(const PinholeCamera& camera, const Mesh& mesh);

  /// Calls `draw(a, b, c)` for the parts of the triangle that are to be filled, in the order of its vertices.
  template <class Draw>
  void forEachPart(uint32_t triangle, const Draw& draw) const {
    const glm::uvec3& t = mesh_.triangles[triangle];
    RasterVertex a = projected_[t.x];
    RasterVertex b = projected_[t.y];
    RasterVertex c = projected_[t.z];
    if (a.inverseZ > 0 && b.inverseZ > 0 && c.inverseZ > 0) {
      b.b1 = 1;
      c.b2 = 1;
      draw(a, b, c);
      return;
    }
    const std::vector<RasterVertex> polygon = clipped(triangle);
    for (size_t i = 2; i < polygon.size(); ++i) {
      draw(polygon[0], polygon[i - 1], polygon[i]);
    }
  }

 private:
  std::vector<RasterVertex> clipped(uint32_t triangle) const;

  const PinholeCamera& camera_;
  const Mesh& mesh_;
  std::vector<RasterVertex> projected_;  ///< 1/z = 0 marks those whose triangles have to be clipped
};

}  // namespace ocelli
