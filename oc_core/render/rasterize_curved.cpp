#include "oc_core/render/rasterize_curved.h"

#include "oc_core/base/parallel.h"
#include "oc_core/render/bend_rasterizer.h"
#include "oc_core/render/camera_segments.h"
#include "oc_core/render/draw_pieces.h"
#include "oc_core/render/pixel_ray.h"
#include "oc_core/render/segment_rasterizer.h"

namespace ocelli {
namespace {

/// z of a point that the ray of a pixel passes in a piece, as the camera measures it.
double depthOf(const CurvedRayCamera& camera, PixelRay ray, size_t order, const glm::dvec3& point) {
  const auto follow = [&](const RayTransition& bend) { ray.bend(bend.planes().middle, bend.beyond()); };
  for (size_t i = 0; i < order / 2; ++i) {
    follow(camera.bends()[i]);
  }
  if (order % 2 == 0) {
    return ray.zOf(point);
  }
  const RayTransition& bend = camera.bends()[order / 2];
  const Plane& from = bend.planes().from;
  const Plane& to = bend.planes().to;
  const double begin = ray.zOf(ray.cross(from));
  const double fromShare = std::max(from.height(point), 0.0) / glm::dot(from.normal, glm::normalize(ray.direction()));
  follow(bend);
  const double end = ray.zOf(ray.cross(to));
  const double toShare = std::max(-to.height(point), 0.0) / glm::dot(to.normal, glm::normalize(ray.direction()));
  const double share = fromShare + toShare > 0 ? fromShare / (fromShare + toShare) : 0;
  return begin + (end - begin) * share;
}

/// A curved ray camera, ready to draw.
struct CurvedDrawing {
  CurvedDrawing(const CurvedRayCamera& camera, const Mesh& mesh, const MeshBlocks& blocks)
      : leaves(camera.width(), camera.height(), 0), segments(segmentsOf(camera)), pieces(2 * segments.size() - 1) {
    parallelFor(pieces.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        if (i % 2 == 0) {
          pieces[i] = std::make_unique<SegmentRasterizer>(segments[i / 2], mesh, blocks, camera.width(),
                                                          camera.height());
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

class CurvedDepths {
 public:
  explicit CurvedDepths(const CurvedRayCamera& camera) : camera_(camera), rays_(camera.root()) {}

  double operator()(int x, int y, uint8_t order, const glm::dvec3& point) const {
    return depthOf(camera_, PixelRay(rays_, {x + 0.5, y + 0.5}), order, point);
  }

 private:
  const CurvedRayCamera& camera_;
  PixelRays rays_;
};

}  // namespace

OrderedBuffer drawOrdered(const CurvedRayCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  const CurvedDrawing drawing(camera, mesh, blocks);
  return orderedBufferOf(drawing.pieces, drawing.leaves, blocks);
}

FragmentImage fragmentsOf(const CurvedRayCamera& camera, const OrderedBuffer& buffer, const Mesh& mesh) {
  return fragmentsOf(buffer, mesh, camera.width(), camera.height(), static_cast<double>(camera.root().view().zFar), CurvedDepths(camera));
}

FragmentImage rasterize(const CurvedRayCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  const CurvedDrawing drawing(camera, mesh, blocks);
  return drawFragments(drawing.pieces, drawing.leaves, mesh, blocks, static_cast<double>(camera.root().view().zFar), CurvedDepths(camera));
}

FragmentImage rasterize(const CurvedRayCamera& camera, const Mesh& mesh) {
  return rasterize(camera, mesh, MeshBlocks(mesh));
}

}  // namespace ocelli
