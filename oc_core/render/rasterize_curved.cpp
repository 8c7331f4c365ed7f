#include "oc_core/render/rasterize_curved.h"

#include <algorithm>

#include "oc_core/base/parallel.h"
#include "oc_core/render/bend_rasterizer.h"
#include "oc_core/render/camera_segments.h"
#include "oc_core/render/draw_pieces.h"
#include "oc_core/render/segment_rasterizer.h"

namespace ocelli {
namespace {

/// A curved ray camera, ready to draw.
struct CurvedDrawing {
  CurvedDrawing(const CurvedRayCamera& camera, const Mesh& mesh, const MeshBlocks& blocks)
      : leaves(camera.width(), camera.height(), 0), segments(segmentsOf(camera)), pieces(2 * segments.size() - 1) {
    parallelFor(pieces.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        if (i % 2 == 0) {
          pieces[i] =
              std::make_unique<SegmentRasterizer>(segments[i / 2], mesh, blocks, camera.width(), camera.height());
        } else {
          pieces[i] = std::make_unique<BendRasterizer>(camera, i / 2, static_cast<uint8_t>(i), mesh, blocks);
        }
      }
    });
  }

  PixelLeaves leaves;
  std::vector<StraightSegment> segments;
  RayPieces pieces;
};

/// z of what rays meet, as the camera measures it.
class CurvedDepths {
 public:
  explicit CurvedDepths(const CurvedRayCamera& camera) : camera_(camera), rays_(camera.root()) {}

  void operator()(int x, int y, uint8_t order, uint16_t /*leaf*/, const RayBatch::Points& points,
                  RayBatch::Lanes& z) const {
    RayBatch rays(rays_, x, y);
    const std::vector<RayTransition>& bends = camera_.bends();
    for (size_t i = 0; i < order / 2u; ++i) {
      rays.bend(bends[i].planes().middle, bends[i].beyond());
    }
    if (order % 2 == 0) {
      rays.zOf(points, z);
    } else {
      zInBend(rays, bends[order / 2u], points, z);
    }
  }

 private:
  static void zInBend(RayBatch& rays, const RayTransition& bend, const RayBatch::Points& points, RayBatch::Lanes& z) {
    const Plane& from = bend.planes().from;
    const Plane& to = bend.planes().to;
    RayBatch::Points at;
    RayBatch::Lanes begin;
    RayBatch::Lanes end;
    RayBatch::Lanes fromShares;
    RayBatch::Lanes toShares;
    RayBatch::Lanes cosines;
    rays.cross(from, at);
    rays.zOf(at, begin);
    rays.cosines(from, cosines);
    RayBatch::heightsOver(from, points, fromShares);
    RayBatch::forEachLane([&](size_t i) { fromShares[i] = std::max(fromShares[i], 0.0) / cosines[i]; });
    rays.bend(bend.planes().middle, bend.beyond());
    rays.cross(to, at);
    rays.zOf(at, end);
    rays.cosines(to, cosines);
    RayBatch::heightsOver(to, points, toShares);
    RayBatch::forEachLane([&](size_t i) {
      toShares[i] = std::max(-toShares[i], 0.0) / cosines[i];
      const double sum = fromShares[i] + toShares[i];
      const double share = sum > 0 ? fromShares[i] / sum : 0;
      z[i] = begin[i] + (end[i] - begin[i]) * share;
    });
  }

  const CurvedRayCamera& camera_;
  PixelRays rays_;
};

}  // namespace

OrderedBuffer drawOrdered(const CurvedRayCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  const CurvedDrawing drawing(camera, mesh, blocks);
  return orderedBufferOf(drawing.pieces, drawing.leaves, blocks);
}

FragmentImage fragmentsOf(const CurvedRayCamera& camera, const OrderedBuffer& buffer, const Mesh& mesh) {
  return fragmentsOf(buffer, PixelLeaves(camera.width(), camera.height(), 0), mesh,
                     static_cast<double>(camera.root().view().zFar), CurvedDepths(camera));
}

FragmentImage rasterize(const CurvedRayCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  const CurvedDrawing drawing(camera, mesh, blocks);
  return drawFragments(drawing.pieces, drawing.leaves, mesh, blocks, static_cast<double>(camera.root().view().zFar),
                       CurvedDepths(camera));
}

FragmentImage rasterize(const CurvedRayCamera& camera, const Mesh& mesh) {
  return rasterize(camera, mesh, MeshBlocks(mesh));
}

}  // namespace ocelli
