#include "oc_core/render/rasterize_curved.h"

#include "oc_core/render/camera_stretches.h"
#include "oc_core/render/draw_tasks.h"
#include "oc_core/render/pixel_ray.h"
#include "oc_core/render/turn_drawer.h"

namespace ocelli {
namespace {

/// z of a point that the ray of a pixel passes in a piece, as the camera measures it.
double depthOf(const CurvedRayCamera& camera, PixelRay ray, size_t order, const glm::dvec3& point) {
  const auto bend = [&](const RayTransition& turn) { ray.bend(turn.planes().middle, turn.beyond()); };
  for (size_t i = 0; i < order / 2; ++i) {
    bend(camera.turns()[i]);
  }
  if (order % 2 == 0) {
    return ray.zOf(point);
  }
  const RayTransition& turn = camera.turns()[order / 2];
  const Plane& from = turn.planes().from;
  const Plane& to = turn.planes().to;
  const double begin = ray.zOf(ray.cross(from));
  const double fromShare = std::max(from.height(point), 0.0) / glm::dot(from.normal, glm::normalize(ray.direction()));
  bend(turn);
  const double end = ray.zOf(ray.cross(to));
  const double toShare = std::max(-to.height(point), 0.0) / glm::dot(to.normal, glm::normalize(ray.direction()));
  const double share = fromShare + toShare > 0 ? fromShare / (fromShare + toShare) : 0;
  return begin + (end - begin) * share;
}

}  // namespace

FragmentImage rasterize(const CurvedRayCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  const PixelLeaves leaves(camera.width(), camera.height(), 0);
  const std::vector<Stretch> stretches = stretchesOf(camera);
  std::vector<StretchDrawer> straight;
  std::vector<TurnDrawer> turns;
  std::vector<BlockTask> tasks;
  for (size_t i = 0; i < stretches.size(); ++i) {
    straight.emplace_back(stretches[i], mesh, blocks, leaves);
    straight.back().bounds().findBlocks(blocks, static_cast<uint32_t>(2 * i), tasks);
    if (i < camera.turns().size()) {
      const size_t order = 2 * i + 1;
      turns.emplace_back(camera, i, static_cast<uint8_t>(order), mesh, blocks);
      turns.back().bounds().findBlocks(blocks, static_cast<uint32_t>(order), tasks);
    }
  }
  struct Scratch {
    StretchDrawer::Scratch straight;
    TurnDrawer::Scratch turn;
  };
  const OrderedBuffer buffer = drawTasks(
      leaves.size(), tasks, [] { return Scratch(); },
      [&](OrderedBuffer& drawn, const BlockTask& task, Scratch& scratch) {
        if (task.piece % 2 == 0) {
          straight[task.piece / 2].draw(drawn, task, scratch.straight);
        } else {
          turns[task.piece / 2].draw(drawn, task, scratch.turn);
        }
      });
  const PixelRays rays(camera.root());
  const auto width = static_cast<size_t>(camera.width());
  return fragmentsOf(buffer, mesh, camera.width(), camera.height(), static_cast<double>(camera.root().view().zFar),
                     [&](size_t pixel, size_t order, const glm::dvec3& point) {
                       const glm::dvec2 centre(static_cast<double>(pixel % width) + 0.5,
                                               static_cast<double>(pixel / width) + 0.5);
                       return depthOf(camera, PixelRay(rays, centre), order, point);
                     });
}

FragmentImage rasterize(const CurvedRayCamera& camera, const Mesh& mesh) {
  return rasterize(camera, mesh, MeshBlocks(mesh));
}

}  // namespace ocelli
