// Turning into a way of the crossing ahead in four steps (section 4.3.1.4), as maze_turn.h does in grids, between two
// poses of the maze camera of a walk map:
//   0 to 1  the ways of the backward camera retract: it becomes a pinhole
//   1 to 2  the viewpoint of the forward camera moves away until its rays come in almost parallel, then it gives all of
//           them to the chosen way
//   2 to 3  the backward camera turns around; the forward one becomes the pinhole before the mouth of the chosen way,
//           whose sides, which end rays until then, swing open
//   3 to 4  the user walks on from there, and the ways deploy again, ahead and behind
#pragma once

#include <utility>

#include "oc_core/constructor/walk_camera.h"

namespace ocelli {

struct WalkTurn {
  WalkPose from;        ///< ahead of it lies the crossing
  uint32_t portal = 0;  ///< of WalkMap::portals: the way out of the crossing that is taken
  double phase = 0;     ///< 0 to 4
};

/// Where the user is at the end of the turn: within the chosen way, half as far from its mouth as it is wide. Throws
/// InputError where the portal is no way out of the crossing ahead.
WalkPose walkPoseAfter(const WalkSpace& space, const WalkTurn& turn);

/// The forward and the backward camera. Throws InputError as well for a phase that is not from 0 to 4, and where
/// makeWalkCamera does.
std::pair<WalkCamera, WalkCamera> walkTurningCameras(const WalkSpace& space, const WalkTurn& turn,
                                                     const WalkCameraOptions& options, int width, int height);

}  // namespace ocelli
