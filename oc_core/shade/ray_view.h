// The view that sees what secondary rays see: from where they seem to come, as wide as they spread, and the cell of
// viewpoints around it that they pass.
//
// Behind a convex mirror, and before a convex lens, the rays of a picture nearly meet: a camera there sees the same
// sides of things, while from the middle of what sends the rays other sides are seen. The meeting point is the one with
// the least sum of squared distances to the lines of the rays. Where things stand around it, as around the focus of a
// lens, the eye moves from there towards the middle of what sends the rays, until all that the rays may meet lies in
// front of it.
//
// DEVIATION: the text captures the depth image "along the direction that connects the centers" of mirror and object
// (section 3.5.2.3.1); referenceView() of shaded_scene.h is that.
#pragma once

#include <optional>
#include <span>

#include "oc_core/camera/view.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/shade/secondary_rays.h"

namespace ocelli {

struct RayView {
  View view;
  float cellSide = 0;  ///< diameter of the cell: 98 of 100 rays that may meet something pass through it
};

/// For images of `width` x `height` pixels, and rays towards `cast`, which nothing needs to have traced: what they may
/// meet is known from a coarse grid of the cells that hold triangles. `middle` is that of what sends the rays. Nothing
/// where fewer than 16 of the rays, or of some thousands of them, may meet anything, where their lines have no
/// meeting point, and where no eye up to the middle sees all that they may meet.
std::optional<RayView> viewOfRays(std::span<const SecondaryRay> rays, const Mesh& cast, const glm::vec3& middle,
                                  int width, int height);

}  // namespace ocelli
