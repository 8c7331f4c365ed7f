// The constructors that one explores with, a file each.
#pragma once

#include "oc_core/explore/live_constructor.h"

namespace ocelli {

LiveConstructorRow livePinhole();
LiveConstructorRow livePortal();
LiveConstructorRow liveOccluder();
LiveConstructorRow liveTarget();
LiveConstructorRow liveMaze();
LiveConstructorRow livePath();
LiveConstructorRow liveComprehensive();
LiveConstructorRow liveDrawn();

}  // namespace ocelli
