// The houses of `builtin:city` and what stands in its streets: closed solids.
#pragma once

#include "oc_core/scene/mesh.h"
#include "oc_core/worlds/city_plan.h"

namespace ocelli {

/// In the frame of the city. Windows with panes in a body that cannot be looked into, a closed door, a roof; along a
/// wall no two lines are farther apart than `maxCell` metres.
Mesh makeCityHouse(const CityHouse& house, float maxCell);

/// Each around the y axis, on y = 0.
Mesh makeFountain();
/// 1.6 m long along x; who sits on it looks to +z.
Mesh makeBench();
Mesh makeBin(const glm::vec3& color);

}  // namespace ocelli
