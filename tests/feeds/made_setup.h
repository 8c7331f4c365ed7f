// A T of corridors 2.4 m wide and 2.8 m high, seen by three feeds: the stem runs along z to the crossing at z in
// [-2.4, 0], the branches along x.
#pragma once

#include "oc_core/feeds/feed_setup.h"

namespace ocelli::test {

/// Feeds "stem", "left" and "right"; the near faces of the branches meet in the middle of the far wall.
FeedSetup tSetup();
/// With a fourth feed, "beyond", whose frustum begins in the left branch at x = -5: a chain of three.
FeedSetup chainSetup();

}  // namespace ocelli::test
