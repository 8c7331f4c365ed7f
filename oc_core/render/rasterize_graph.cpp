#include "oc_core/render/rasterize_graph.h"

#include <algorithm>
#include <array>

#include "oc_core/render/camera_segments.h"
#include "oc_core/render/draw_pieces.h"
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
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const auto& a, const auto& b) { return a->order() < b->order(); });
  }

  PixelLeaves leaves;
  std::vector<StraightSegment> segments;
  RayPieces pieces;
};

/// z of what rays meet, as the camera measures it.
class GraphDepths {
 public:
  explicit GraphDepths(const GraphCamera& camera) : rays_(camera.root()) {
    for (const GraphCamera::Frustum& frustum : camera.frusta()) {
      ways_.push_back(frustum.parent < 0 ? decltype(ways_)::value_type() : ways_[static_cast<size_t>(frustum.parent)]);
      ways_.back().push_back(&frustum);
    }
  }

  void operator()(int x, int y, uint8_t order, uint16_t leaf, const RayBatch::Points& points,
                  RayBatch::Lanes& z) const {
    RayBatch rays(rays_, x, y);
    for (size_t i = 1; i <= order; ++i) {
      rays.bend(ways_[leaf][i]->plane, ways_[leaf][i]->viewpoint);
    }
    rays.zOf(points, z);
  }

 private:
  PixelRays rays_;
  std::vector<std::vector<const GraphCamera::Frustum*>> ways_;  ///< to each leaf, from the root
};

}  // namespace

OrderedBuffer drawOrdered(const GraphCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  const GraphDrawing drawing(camera, mesh, blocks);
  return orderedBufferOf(drawing.pieces, drawing.leaves, blocks);
}

FragmentImage fragmentsOf(const GraphCamera& camera, const OrderedBuffer& buffer, const Mesh& mesh) {
  return fragmentsOf(buffer, leavesOf(camera), mesh, static_cast<double>(camera.root().view().zFar),
                     GraphDepths(camera));
}

FragmentImage rasterize(const GraphCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  const GraphDrawing drawing(camera, mesh, blocks);
  return drawFragments(drawing.pieces, drawing.leaves, mesh, blocks, static_cast<double>(camera.root().view().zFar),
                       GraphDepths(camera));
}

void visitSamples(const GraphCamera& camera, const Mesh& mesh, const MeshBlocks& blocks,
                  const std::function<void(const RegionBuffer::SampleRun& run)>& visit) {
  const GraphDrawing drawing(camera, mesh, blocks);
  drawPieces(drawing.pieces, drawing.leaves, blocks,
             [&](const RegionBuffer& region) { region.forEachRun(static_cast<size_t>(camera.width()), visit); });
}

bool endsBeforeZFar(const GraphCamera& camera, const Box& bounds) {
  constexpr double kRounding = 1e-5;
  const std::array<glm::vec3, 8> corners = cornersOf(bounds);
  std::vector<glm::dvec3> viewpoints;
  std::vector<double> ways;  // from the eye to each viewpoint, over those before it
  double longest = 0;
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    const bool isRoot = frustum.parent < 0;
    viewpoints.push_back(isRoot ? glm::dvec3(camera.root().eye()) : frustum.viewpoint);
    const auto parent = static_cast<size_t>(std::max(frustum.parent, 0));
    ways.push_back(isRoot ? 0 : ways[parent] + glm::distance(viewpoints[parent], viewpoints.back()));
    for (const glm::vec3& corner : corners) {
      longest = std::max(longest, ways.back() + glm::distance(viewpoints.back(), glm::dvec3(corner)));
    }
  }
  return longest * (1 + kRounding) < static_cast<double>(camera.root().view().zFar);
}

FragmentImage rasterize(const GraphCamera& camera, const Mesh& mesh) {
  return rasterize(camera, mesh, MeshBlocks(mesh));
}

}  // namespace ocelli
