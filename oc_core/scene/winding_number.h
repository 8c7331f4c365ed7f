// Is a point inside a solid? The generalised winding number: the solid angle of all triangles around it, over 4 pi
// (Van Oosterom and Strackee's formula for a triangle).
#pragma once

#include <string>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// 1 inside a closed mesh whose triangles face outwards (-1 where they face inwards), 0 outside; in between for open
/// ones.
double windingNumber(const Mesh& mesh, const glm::vec3& point);

/// Throws InputError where `eye` lies inside a closed object, so that a view from there shows its inside only. An
/// object is what shares vertices, or the mesh as a whole. Costs nothing to speak of for an eye out of the mesh's
/// bounds. Of a part of a scene (Mesh::isPart) that cannot be told, and nothing is thrown: who takes the part must have
/// asked the scene.
void requireOutside(const Mesh& mesh, const glm::vec3& eye, const std::string& where);

}  // namespace ocelli
