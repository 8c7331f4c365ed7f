#include "oc_core/render/rasterize_curved.h"

#include "oc_core/render/bend_rasterizer.h"
#include "oc_core/render/camera_segments.h"
#include "oc_core/render/draw_tasks.h"
#include "oc_core/render/pixel_ray.h"

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

}  // namespace

OrderedBuffer drawOrdered(const CurvedRayCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  const PixelLeaves leaves(camera.width(), camera.height(), 0);
  const std::vector<StraightSegment> segments = segmentsOf(camera);
  std::vector<SegmentRasterizer> straight;
  std::vector<BendRasterizer> bends;
  std::vector<BlockTask> tasks;
  for (size_t i = 0; i < segments.size(); ++i) {
    straight.emplace_back(segments[i], mesh, blocks, leaves);
    straight.back().bounds().findBlocks(blocks, static_cast<uint32_t>(2 * i), tasks);
    if (i < camera.bends().size()) {
      const size_t order = 2 * i + 1;
      bends.emplace_back(camera, i, static_cast<uint8_t>(order), mesh, blocks);
      bends.back().bounds().findBlocks(blocks, static_cast<uint32_t>(order), tasks);
    }
  }
  struct Scratch {
    SegmentRasterizer::Scratch straight;
    BendRasterizer::Scratch bend;
  };
  return drawTasks(
      leaves.size(), tasks, [] { return Scratch(); },
      [&](OrderedBuffer& drawn, const BlockTask& task, Scratch& scratch) {
        if (task.piece % 2 == 0) {
          straight[task.piece / 2].draw(drawn, task, scratch.straight);
        } else {
          bends[task.piece / 2].draw(drawn, task, scratch.bend);
        }
      });
}

FragmentImage fragmentsOf(const CurvedRayCamera& camera, const OrderedBuffer& buffer, const Mesh& mesh) {
  const PixelRays rays(camera.root());
  const auto width = static_cast<size_t>(camera.width());
  return fragmentsOf(buffer, mesh, camera.width(), camera.height(), static_cast<double>(camera.root().view().zFar),
                     [&](size_t pixel, size_t order, const glm::dvec3& point) {
                       const glm::dvec2 centre(static_cast<double>(pixel % width) + 0.5,
                                               static_cast<double>(pixel / width) + 0.5);
                       return depthOf(camera, PixelRay(rays, centre), order, point);
                     });
}

FragmentImage rasterize(const CurvedRayCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  return fragmentsOf(camera, drawOrdered(camera, mesh, blocks), mesh);
}

FragmentImage rasterize(const CurvedRayCamera& camera, const Mesh& mesh) {
  return rasterize(camera, mesh, MeshBlocks(mesh));
}

}  // namespace ocelli
