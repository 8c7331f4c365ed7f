// What stands in the streets of `builtin:town`: each around the y axis, on y = 0, made of closed solids.
#pragma once

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// About 5 m high.
Mesh makeRoundTree(const glm::vec3& color);
Mesh makePointedTree(const glm::vec3& color);
/// 4 m long, towards +x.
Mesh makeCar(const glm::vec3& color);
/// Its arm reaches towards +z.
Mesh makeLamp();
/// Clock faces on all four sides.
Mesh makeClockTower();

}  // namespace ocelli
