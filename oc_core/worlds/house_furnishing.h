// Puts furniture into the rooms of `builtin:house` so that one still comes from each door to the others and to all that
// is left of the floor.
#pragma once

#include <cstddef>

#include "oc_core/base/random.h"
#include "oc_core/worlds/house_plan.h"

namespace ocelli {

inline constexpr float kWalkerRadius = 0.3f;  ///< metres; of who has to come through between furniture and walls

/// Whether a walker comes from each door of the room to the others, and to all places of its floor where he has room.
/// Checked on a grid of 0.1 m.
bool isRoomWalkable(const HousePlan& plan, size_t room);

/// Adds what belongs to a room of its kind, as far as there is place for it.
void furnishRoom(HousePlan& plan, size_t room, Random& random);

}  // namespace ocelli
