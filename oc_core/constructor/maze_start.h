// Where a camera that shows a whole maze begins: a bundle of almost parallel rays through the opening of its first
// cell, as wide and as tall as the opening, which fills the image.
//
// Before the entrance the root looks along the outer wall, and turns in at a slanted plane: as wide as the opening
// where rays leave it, as wide as an image of this shape where they come in. So the whole image shows the maze,
// stretched to its shape. Within a maze there is no room for that; there the image shows the opening as it is, with
// empty borders.
#pragma once

#include "oc_core/camera/graph_camera.h"
#include "oc_core/scene/maze.h"

namespace ocelli {

struct MazeStart {
  GraphCamera camera;
  int frustum;         ///< that of the bundle
  glm::dvec3 left{0};  ///< of the opening, on the floor
  glm::dvec3 right{0};
  glm::dvec3 heading{0};
};

/// How one comes into the first cell, and what is to be seen of the opening.
struct MazeOpening {
  MazeCell cell;
  Direction heading = Direction::kNorth;
  double height = 0;      ///< from the floor to the viewpoints, at the upper border of the image
  double longestRay = 0;  ///< within the maze, about
};

/// An image of that size.
MazeStart startOf(const Maze& maze, const MazeOpening& opening, int width, int height);

}  // namespace ocelli
