// Closed solids around the origin, counter-clockwise seen from outside, with shared vertices and no colours.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The box of the given half sizes: 8 vertices, 12 triangles.
Mesh makeBox(const glm::vec3& half);

/// The unit sphere: `segments` (3 or more) around the y axis, half as many (2 or more) from pole to pole.
Mesh makeSphere(int segments);

/// A ring around the z axis: tube radius `tubeRadius` around a circle of radius 1 - tubeRadius. `segments` (3 or more)
/// around the axis and half as many (3 or more) around the tube.
Mesh makeTorus(float tubeRadius, int segments);

/// What a `profile` of (radius, height) points sweeps around the y axis, in `segments` (3 or more). It runs from the
/// bottom to the top, with radius 0 at both ends and nowhere else.
Mesh makeTurned(const std::vector<glm::vec2>& profile, int segments);

/// The convex `outline` (three points or more, counter-clockwise) in the planes z = -halfDepth and z = halfDepth, and
/// what lies between.
Mesh makePrism(const std::vector<glm::vec2>& outline, float halfDepth);

/// Gives every vertex the same linear colour.
void paint(Mesh& mesh, const glm::vec3& color);

}  // namespace ocelli
