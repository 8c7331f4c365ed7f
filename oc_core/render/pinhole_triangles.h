// The triangles of a mesh as a planar pinhole camera sees them: vertices projected once, clipped where they have to be.
#pragma once

#include <vector>

#include "oc_core/render/frustum_clip.h"
#include "oc_core/render/projected_mesh.h"
#include "oc_core/render/visibility_buffer.h"

namespace ocelli {

class PinholeTriangles {
 public:
  /// `projected` must outlive it.
  explicit PinholeTriangles(const ProjectedMesh& projected)
      : projected_(projected),
        upper_(glm::vec2(projected.camera().width(), projected.camera().height()) + kClipMargin) {}

  /// Calls `draw(a, b, c)` for the parts of the triangle that are to be filled, in the order of its vertices; for none
  /// where none covers a pixel centre, as far as a quick look tells.
  template <class Draw>
  void forEachPart(uint32_t triangle, const Draw& draw) const {
    if (!projected_.missesCentres(projected_.mesh().triangles[triangle])) {
      forEachPartAnywhere(triangle, draw);
    }
  }
  /// The same for those too that cover no pixel centre of the pinhole.
  template <class Draw>
  void forEachPartAnywhere(uint32_t triangle, const Draw& draw) const {
    const glm::uvec3& t = projected_.mesh().triangles[triangle];
    if (isWithin(projected_.vertex(t.x)) && isWithin(projected_.vertex(t.y)) && isWithin(projected_.vertex(t.z))) {
      const ProjectedVertex& a = projected_.vertex(t.x);
      const ProjectedVertex& b = projected_.vertex(t.y);
      const ProjectedVertex& c = projected_.vertex(t.z);
      draw(RasterVertex{a.u, a.v, a.inverseZ, 0, 0}, RasterVertex{b.u, b.v, b.inverseZ, 1, 0},
           RasterVertex{c.u, c.v, c.inverseZ, 0, 1});
      return;
    }
    const std::vector<RasterVertex> polygon = clipped(triangle);
    for (size_t i = 2; i < polygon.size(); ++i) {
      draw(polygon[0], polygon[i - 1], polygon[i]);
    }
  }

 private:
  bool isWithin(const glm::vec2& image) const {
    return image.x > -kClipMargin && image.y > -kClipMargin && image.x < upper_.x && image.y < upper_.y;
  }
  bool isWithin(const ProjectedVertex& v) const { return v.inverseZ > 0 && isWithin(glm::vec2(v.u, v.v)); }
  std::vector<RasterVertex> clipped(uint32_t triangle) const;

  const ProjectedMesh& projected_;
  glm::vec2 upper_;
};

}  // namespace ocelli
