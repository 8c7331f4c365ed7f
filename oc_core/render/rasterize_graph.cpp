#include "oc_core/render/rasterize_graph.h"

#include "oc_core/render/camera_segments.h"
#include "oc_core/render/draw_tasks.h"
#include "oc_core/render/pixel_ray.h"

namespace ocelli {

OrderedBuffer drawOrdered(const GraphCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  const PixelLeaves leaves = leavesOf(camera);
  const std::vector<StraightSegment> segments = segmentsOf(camera, leaves);
  std::vector<SegmentRasterizer> renderers;
  std::vector<BlockTask> tasks;
  for (const StraightSegment& segment : segments) {
    renderers.emplace_back(segment, mesh, blocks, leaves);
    renderers.back().bounds().findBlocks(blocks, static_cast<uint32_t>(renderers.size() - 1), tasks);
  }
  return drawTasks(
      leaves.size(), tasks, [] { return SegmentRasterizer::Scratch(); },
      [&](OrderedBuffer& drawn, const BlockTask& task, SegmentRasterizer::Scratch& scratch) {
        renderers[task.piece].draw(drawn, task, scratch);
      });
}

FragmentImage fragmentsOf(const GraphCamera& camera, const OrderedBuffer& buffer, const Mesh& mesh) {
  const PixelLeaves leaves = leavesOf(camera);
  // The frusta on the way to each leaf, from the root.
  std::vector<std::vector<const GraphCamera::Frustum*>> ways;
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    ways.push_back(frustum.parent < 0 ? decltype(ways)::value_type() : ways[static_cast<size_t>(frustum.parent)]);
    ways.back().push_back(&frustum);
  }
  const PixelRays rays(camera.root());
  const auto width = static_cast<size_t>(camera.width());
  return fragmentsOf(
      buffer, mesh, camera.width(), camera.height(), static_cast<double>(camera.root().view().zFar),
      [&](size_t pixel, size_t order, const glm::dvec3& point) {
        PixelRay ray(rays, {static_cast<double>(pixel % width) + 0.5, static_cast<double>(pixel / width) + 0.5});
        for (size_t i = 1; i <= order; ++i) {
          ray.bend(ways[leaves[pixel]][i]->plane, ways[leaves[pixel]][i]->viewpoint);
        }
        return ray.zOf(point);
      });
}

FragmentImage rasterize(const GraphCamera& camera, const Mesh& mesh, const MeshBlocks& blocks) {
  return fragmentsOf(camera, drawOrdered(camera, mesh, blocks), mesh);
}

FragmentImage rasterize(const GraphCamera& camera, const Mesh& mesh) {
  return rasterize(camera, mesh, MeshBlocks(mesh));
}

}  // namespace ocelli
