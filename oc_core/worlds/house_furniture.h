// The furniture of `builtin:house`: closed solids on y = 0 around the y axis, within furnitureSize(); the front looks
// to +z.
#pragma once

#include "oc_core/scene/mesh.h"
#include "oc_core/worlds/house_plan.h"

namespace ocelli {

Mesh makeFurniture(FurnitureKind kind, const glm::vec3& color);

}  // namespace ocelli
