// The camera for exploring a maze (section 4.3.1.4, Figures 4.17 and 4.18): someone who walks along a corridor sees to
// the first crossing ahead, and along all ways that leave it. The backward camera does so behind.
//
// The root frustum begins at the user, as wide as the corridor there, and its viewpoint lies so far behind that the
// crossing takes a given part of the image, however far away it is. Of the rays that reach the crossing, each way gets
// a share: the split ratio. Where ways are missing, the others have their shares.
//
// Just before a crossing with a way ahead, within it and just behind it, ways to the sides are retracted
// (maze_walk.h): the camera is a pinhole at the user's eye. So images change without a jump as the user walks on.
#pragma once

#include <array>
#include <optional>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/constructor/maze_walk.h"

namespace ocelli {

class JsonFields;

struct MazeCameraOptions {
  std::array<double, 3> split{1.0 / 3, 1.0 / 3, 1.0 / 3};  ///< of rays, to the left, ahead and to the right
  bool backward = false;
  double fovHorizontalDegrees = 70;  ///< of the pinhole, and the widest of the root
  double fovCorridorDegrees = 40;    ///< at the beginning of the ways that leave the crossing
  double crossingShare = 0.8;        ///< of the image's width, where a way leads to the sides
  double deployCells = 1;            ///< over how many cells of the way ways to the sides deploy
  std::optional<double> deployed{};  ///< instead of what the position allows; 0 is a pinhole, 1 deployed in full
  double parallel = 0;               ///< 1 moves the viewpoint of the root away until its rays are almost parallel
};

/// An image of that size. Throws InputError where the eye is not in a corridor, where a wall stands before the user and
/// no way leads to a side, and where the split ratios are negative or do not add up to 1.
GraphCamera makeMazeCamera(const Maze& maze, const MazePose& pose, const MazeCameraOptions& options, int width,
                           int height);

/// The pinhole of the user's eye, with the field of view of the options, to any side.
PinholeCamera mazePinhole(const Maze& maze, const glm::dvec3& eye, const glm::dvec3& direction,
                          const MazeCameraOptions& options, int width, int height);

struct MazeCameraPlace {
  MazePose pose;
  MazeCameraOptions options;
};

/// The eye and the direction of `reference` where the file does not give "position" and "heading". Throws InputError
/// for fields that are wrong.
MazeCameraPlace readMazeCamera(JsonFields& fields, const PinholeCamera& reference);

}  // namespace ocelli
