// How the rays of a graph camera that come along a corridor of a maze go on at a crossing: to the left, ahead and to
// the right, each way with a share of the crossing's width (sections 4.3.1.4 and 4.3.2.2, Figure 4.18).
//
// Plan of the crossing's box, seen along the heading; w is the clear width:
//
//     S0 ______________ S1        Without a way ahead, the rays of a side turn at the plane from its near corner E to a
//       |              |          point of the far wall. Rays that come in nearly parallel leave so, over the whole
//       |  Pl____Pr    |          depth of the side way: nothing is lost.
//       |  /      \    |          With one, they turn at E-Pl, away from a viewpoint on the line S0-Pl, and again where
//       | /        \   |          the side way begins. Those ahead turn at Pl-Pr, and fan out from there to S0 and S1,
//     E |/__________\__| E'       where they turn again. So every point of the box is seen once.
//
// How deep Pl lies is a matter of choice: rays to the side lose height the nearer it is, those ahead the farther. Where
// its depth is the share of the way ahead, all three fans have one viewpoint, on the near face: then the image has no
// jump within the box. In any case it has one beyond S0 and S1, where walls part the ways.
//
// All planes are vertical and all viewpoints at one height, so vertical lines stay vertical in the image.
//
// DEVIATION: the text's PPC1 and PPC2, which part rays at the near face of the box, lose half of the height for each
// side way, and part the way ahead into two.
#pragma once

#include <array>
#include <string>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/scene/maze.h"

namespace ocelli {

/// The plan of the box of a cell for who comes in with a heading: x to the right, z ahead, from the near left corner.
struct CrossingFrame {
  CrossingFrame(const Maze& maze, const MazeCell& cell, Direction heading);
  glm::dvec3 at(double x, double z, double y = 0) const { return corner + right * x + ahead * z + up * y; }
  /// Left and right exchanged.
  CrossingFrame mirrored() const;

  glm::dvec3 corner{0};  ///< on the floor
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 ahead{0, 0, 1};
  glm::dvec3 up{0, 1, 0};
  double width = 0;   ///< w
  double height = 0;  ///< of the walls
};

/// Of a way out of a crossing.
struct WayOut {
  double share = 0;         ///< of the crossing's width; 0 where there is no such way
  double viewDistance = 1;  ///< how far behind the beginning of the way the viewpoint of its rays lies; 0 for a wall
};

struct WaysOut {
  std::array<WayOut, 3> way;  ///< to the left, ahead and to the right; shares add up to 1
  double depth = 1;           ///< of Pl and Pr, in widths from the near face; 1 for the far wall, without a way ahead
  double straight = 0;        ///< how far rays ahead keep their direction, to 1: not bent at all
  bool endInBox = true;       ///< rays that find no way end in the box of the crossing
};

/// Adds the frusta of the ways out of the crossing `cell`, for the rays of frustum `i` with the viewpoints' height
/// above the floor. The last frustum of each way, -1 for none.
std::array<int, 3> addWaysOut(GraphCamera& camera, int i, const Maze& maze, const MazeCell& cell, Direction heading,
                              const WaysOut& ways, double eyeHeight);

/// Of the rays of frustum `i`, those that pass between the vertical lines through two points on the floor, up to the
/// height; empty for none.
GraphCamera::Part partBetween(const GraphCamera& camera, int i, const glm::dvec3& a, const glm::dvec3& b,
                              double height);

/// Rays of frustum `i` that go on to no child end at the sides of the box and in its floor.
void limitToBox(GraphCamera& camera, int i, const Box& box);

}  // namespace ocelli
