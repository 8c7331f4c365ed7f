// Where rays that came through a door are free to part. The leaf of an open door stands beside the way into the room,
// as deep as the door is wide, and walk maps don't know it: rays that part at the door itself end at it.
#pragma once

#include "oc_core/camera/graph_camera.h"
#include "oc_core/constructor/walk_piece.h"
#include "oc_core/constructor/walk_region.h"

namespace ocelli {

/// Whether a leaf may hang in an opening: a lintel is over it, which no joint and no mouth of a street has.
bool isDoor(const WalkRegion& region, const WalkMouth& mouth);

/// What the rays that come into a region through a door, or a part of it, fill beyond most of its leaf,
/// up to the height of the door. Of other openings, the opening itself.
WalkMouth beyondLeaf(const GraphCamera& camera, const WalkRegion& region, const PieceRays& rays, const WalkMouth& door);

}  // namespace ocelli
