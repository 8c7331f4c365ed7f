// What a frustum of a graph camera sees of a flat convex polygon, such as an opening or a piece of floor.
#pragma once

#include <span>

#include "oc_core/camera/graph_camera.h"

namespace ocelli {

/// Its image within the part of frustum `i`, clockwise as seen; empty where it is less than a thousandth of a square
/// pixel. What lies before the plane where the frustum begins is not seen.
GraphCamera::Part frustumImage(const GraphCamera& camera, int i, std::span<const glm::dvec3> corners);

/// Bends frustum `i` in the part. Where rounding lets that reach into another child, or out of the frustum, it is made
/// smaller by less than a thousandth of a pixel. -1 where the bend cannot be made: rays that do not cross its plane in
/// order, too many turns, no part.
int bendWhereOneCan(GraphCamera& camera, int i, const GraphCamera::Bend& bend, const std::string& name,
                    const GraphCamera::Part& part);

/// Limits frustum `i`, unless the middle of its rays begins beyond the plane: then it is no limit for them.
void limitWhereOneCan(GraphCamera& camera, int i, const Plane& limit);

}  // namespace ocelli
