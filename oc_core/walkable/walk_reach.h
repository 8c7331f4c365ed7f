// Where the agent gets to: floor that is wide enough for it, in parts of which each can be walked over as a whole.
#pragma once

#include <cstddef>

#include "oc_core/walkable/walk_field.h"

namespace ocelli {

struct WalkReach {
  WalkField field;            ///< of the parts that are kept; squares of different parts are not joined
  double tooNarrowArea = 0;   ///< of squares that no position of the agent covers
  double smallPartsArea = 0;  ///< of the parts that are left out
  size_t smallParts = 0;
};

/// The agent covers a square of 2 `radius` + 1 squares. Parts smaller than `partShare` of the largest are left out, and
/// where that is not 0 also roofs, which lie under the open sky and mostly over other parts, and attics, which lie
/// mostly over the largest part.
WalkReach reachOf(const WalkField& field, int radius, double partShare);

}  // namespace ocelli
