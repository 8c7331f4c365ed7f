#include "oc_core/render/rasterize_graph.h"

#include <algorithm>

#include "oc_core/render/camera_segments.h"
#include "oc_core/render/draw_pieces.h"
#include "oc_core/render/pixel_ray.h"
#include "oc_core/render/segment_rasterizer.h"

namespace ocelli {
namespace {

/// A graph camera, ready to draw.
struct GraphDrawing {
  GraphDrawing(const GraphCamera& camera, const Mesh& mesh, const MeshBlocks& blocks)
      : leaves(leavesOf(camera)), segments(segmentsOf(camera, leaves)) {
    for (const StraightSegment& segment : segments) {
      pieces.push_back(std::make_unique<SegmentRasterizer>(segment, mesh, blocks, camera.width(), camera.height()));
    }
    std::stable_sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a->order() < b->order(); });
  }

  PixelLeaves leaves;
  std::vector<StraightSegment> segments;
  RayPieces pieces;
};

/// z of what rays meet, as the camera measures it.
class GraphDepths {
 public:
  GraphDepths(const GraphCamera& camera, const PixelLeaves& leaves) : leaves_(leaves), rays_(camera.root()) {
    for (const GraphCamera::Frustum& frustum : camera.frusta()) {
      ways_.push_back(frustum.parent < 0 ? decltype(ways_)::value_type() : ways_[static_cast<size_t>(frustum.parent)]);
      ways_.back().push_back(&frustum);
    }
  }

  double operator()(int x, int y, uint8_t order, const glm::dvec3& point) const {
    PixelRay ray(rays_, {x + 0.5, y + 0.5});
    const std::vector<const GraphCamera::Frustum*>& way = ways_[leaves_(x, y)];
    for (size_t i = 1; i <= order; ++i) {
      ray.bend(way[i]->plane, way[i]->viewpoint);
    }
    return ray.zOf(point);
  }

 private:
  const PixelLeaves& leaves_;
  PixelRays rays_;
  std::vector<std::vector<const GraphCamera::Frustum*>> ways_;  ///< to each leaf, from the root
};

}  // namespace

OrderedBuffer drawOrdered(const GraphCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  const GraphDrawing drawing(camera, mesh, blocks);
  return orderedBufferOf(drawing.pieces, drawing.leaves, blocks);
}

FragmentImage fragmentsOf(const GraphCamera& camera, const OrderedBuffer& buffer, const Mesh& mesh) {
  const PixelLeaves leaves = leavesOf(camera);
  return fragmentsOf(buffer, mesh, camera.width(), camera.height(), static_cast<double>(camera.root().view().zFar), GraphDepths(camera, leaves));
}

FragmentImage rasterize(const GraphCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  const GraphDrawing drawing(camera, mesh, blocks);
  return drawFragments(drawing.pieces, drawing.leaves, mesh, blocks, static_cast<double>(camera.root().view().zFar),
                       GraphDepths(camera, drawing.leaves));
}

FragmentImage rasterize(const GraphCamera& camera, const Mesh& mesh) {
  return rasterize(camera, mesh, MeshBlocks(mesh));
}

}  // namespace ocelli
