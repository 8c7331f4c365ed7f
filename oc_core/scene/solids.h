// Closed solids around the origin, counter-clockwise seen from outside, with shared vertices and no colours.
#pragma once

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The box of the given half sizes: 8 vertices, 12 triangles.
Mesh makeBox(const glm::vec3& half);

/// The unit sphere: `segments` (3 or more) around the y axis, half as many (2 or more) from pole to pole.
Mesh makeSphere(int segments);

/// A ring around the z axis: tube radius `tubeRadius` around a circle of radius 1 - tubeRadius. `segments` (3 or more)
/// around the axis and half as many (3 or more) around the tube.
Mesh makeTorus(float tubeRadius, int segments);

/// Gives every vertex the same linear colour.
void paint(Mesh& mesh, const glm::vec3& color);

}  // namespace ocelli
