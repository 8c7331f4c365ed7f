// Turning at a crossing of a maze in four steps (section 4.3.1.4), between two poses of the maze camera:
//   0 to 1  the ways to the sides of the backward camera retract: it becomes a pinhole
//   1 to 2  the viewpoint of the forward camera moves away until its rays come in parallel, then it gives all of them
//           to the chosen way
//   2 to 3  the backward camera turns around; the forward one takes on the field of view of a pinhole, which leaves
//           the image that one has before the mouth of the chosen way
//   3 to 4  the user walks on from there, and the ways to the sides deploy again, ahead and behind
// The images are continuous in the phase.
#pragma once

#include <utility>

#include "oc_core/constructor/maze_constructor.h"

namespace ocelli {

struct MazeTurn {
  MazePose from;     ///< ahead of it lies the crossing
  bool left = true;  ///< or right
  double phase = 0;  ///< 0 to 4
};

/// Where the user is at the end of the turn: half a cell into the chosen way. Throws InputError where there is no
/// crossing ahead, or no way to that side.
MazePose poseAfter(const Maze& maze, const MazeTurn& turn);

/// The forward and the backward camera. Throws InputError as well for a phase that is not from 0 to 4.
std::pair<GraphCamera, GraphCamera> turningCameras(const Maze& maze, const MazeTurn& turn,
                                                   const MazeCameraOptions& options, int width, int height);

}  // namespace ocelli
