// The houses of `builtin:town`.
#pragma once

#include <cstddef>

#include "oc_core/worlds/town_plan.h"

namespace ocelli {

/// A hollow house in its own frame, made of closed solids: walls with real openings, a door that stands open, windows
/// with panes but for those of the ground floor in front, floors, a roof, something inside. Between two lines of
/// openings its walls have `detail` (1 or more) cells either way.
Mesh makeHouse(const House& house, size_t detail);

}  // namespace ocelli
