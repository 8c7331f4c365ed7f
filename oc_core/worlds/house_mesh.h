// What `builtin:house` is built of, from its plan: closed solids, in metres.
#pragma once

#include "oc_core/scene/mesh.h"
#include "oc_core/worlds/house_plan.h"

namespace ocelli {

/// Walls with doorways and windows with panes, frames, floors, ceilings, stairs with railings, the terrace and the
/// roof. No two lines along a wall are farther apart than `maxCell` metres.
Mesh makeHouseShell(const HousePlan& plan, float maxCell);

/// The open leaf of a door that has one.
Mesh makeDoorLeaf(const HouseDoor& door, const glm::vec3& color);

}  // namespace ocelli
