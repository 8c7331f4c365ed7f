// The vertices of a mesh in the image of a general pinhole camera, for filling its triangles: placed in runs, zone by
// zone, for the zones that a run's box touches; most runs touch one or none.
#pragma once

#include <memory>
#include <span>

#include "oc_core/render/gpc_raster_zone.h"
#include "oc_core/render/projected_mesh.h"

namespace ocelli {

struct GpcVertex {
  float x = 0;  ///< in the camera's image, pixels
  float y = 0;
  float inverseZ = 0;
  CentreCell cell;
  uint32_t part = GpcRasterZone::kAround;
  GpcBend bend;  ///< unknown where the vertex has no image, or one so far out that triangles are clipped

  bool isKnown() const { return bend.xx < GpcBend::kUnknown; }
};

class GpcVertices {
 public:
  /// Both must outlive it.
  GpcVertices(std::span<const GpcRasterZone> zones, const ProjectedMesh& projected);

  const GpcVertex& operator[](uint32_t i) const { return vertices_[i]; }
  /// The same for at most GpcRun::kSize points of the pinhole's image; `placed` may be memory that holds nothing yet.
  void place(std::span<const ProjectedVertex> points, std::span<GpcVertex> placed) const;

 private:
  std::span<const GpcRasterZone> zones_;
  glm::vec2 lowest_;  ///< points beyond are clipped
  glm::vec2 highest_;
  /// Memory that is not written before the vertices are: for a million of them that is time.
  struct Deallocate {
    size_t count;
    void operator()(GpcVertex* vertices) const { std::allocator<GpcVertex>().deallocate(vertices, count); }
  };
  std::unique_ptr<GpcVertex[], Deallocate> vertices_;
};

}  // namespace ocelli
