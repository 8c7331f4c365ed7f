// Where rays first hit reference images, on the GPU: the walk of sample_pyramid.h as a compute shader, with the same
// test of triangles in double precision. So it finds the same triangle, but where a driver computes otherwise.
#pragma once

#include <optional>
#include <span>

#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/gl/gl_fragments.h"
#include "oc_core/gl/gl_mesh.h"
#include "oc_core/gl_rays/gl_rays.h"

namespace ocelli {

/// Of an image of rays, a texel a ray.
struct GlRayHits {
  /// The distance from the origin in world units, the triangle, and the weights of its second and third vertex;
  /// Fragment::kNoTriangle where the ray hits nothing. kUnansweredDistance with it where the walk was given up, as it
  /// must be on software renderers (they end a shader after 65535 iterations of its loops) for rays that run along a
  /// surface through more than a thousand cells.
  GlFragments fragments;
  GlObject colors;  ///< GL_RGBA32F: linear, alpha 1; 0 where nothing is hit
  GlObject costs;   ///< GL_RGBA32UI: nodes, cells, boxes and triangles, as RayCost has them
};
inline constexpr float kUnansweredDistance = -1;

class GlRayWalk {
 public:
  /// Uploads what can be hit, and keeps none of it. The context must outlive it. Throws GlError where the GPU has no
  /// room, or its driver refuses a shader. Hold a GlScope, here and below.
  GlRayWalk(GlContext& context, const SampleCells& cells, const SamplePyramid& pyramid);
  GlRayWalk(GlContext& context, const DepthImageTarget& target);

  /// Others in place of those before; faster than another walk.
  void setTarget(const SampleCells& cells, const SamplePyramid& pyramid);

  /// The first hit of each ray, from either side of a surface; nothing for rays that DepthImageTarget::hit() does not
  /// cast. The hits stay on the GPU.
  GlRayHits walk(const GlRays& rays) const;

  /// What can be hit: triangles as GlRayHits numbers them.
  const GlMesh& mesh() const { return mesh_; }
  /// The most steps that a ray can take.
  size_t maxSteps() const { return maxSteps_; }

 private:
  void makeProgramFor(size_t waiting);

  GlContext* context_;
  GlMesh mesh_;
  GlObject nodes_;
  GlObject firstTriangle_;
  uint32_t root_ = 0;
  uint32_t maxIterations_ = 0;
  size_t maxSteps_ = 0;
  size_t maxWaiting_ = 0;  ///< that the program has room for
  GlObject program_;
};

/// Casts rays of a list at a target whose walk is on the GPU, and reads back what they hit: as DepthImageTarget::hit(),
/// with the cost of each ray. Rays that are left unanswered, and those that bend, are cast on the CPU. Hold a GlScope.
void castOnGpu(GlContext& context, const GlRayWalk& walk, const DepthImageTarget& target, std::span<const RayPath> rays,
               std::span<std::optional<Hit>> found, std::span<RayCost> costs);

}  // namespace ocelli
