// Many blocks on a floor with one to keep in sight: what target tracking is tried on (dissertation, section 4.3.1.3).
#pragma once

#include <cstddef>
#include <cstdint>

#include "oc_core/scene/scene.h"

namespace ocelli {

/// `count` blocks (1 or more) of random sizes, no two of which meet, on a patterned floor; the scene just fits the unit
/// sphere. Block i has the identity i + 1. One near the middle, low and red, is the target of the guides.
Scene makeBlocksOnFloor(size_t count, uint64_t seed);

}  // namespace ocelli
