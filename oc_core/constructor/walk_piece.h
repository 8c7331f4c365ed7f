// How all rays that come into a region go on to its exits and its walls, as frusta of a graph camera.
//
// The opening that they come in by is shared out in strips, from left to right: one for each exit, and for the walls
// between those that lie ahead. Each strip has a viewpoint of its own before the opening, so that its rays run from one
// side of what it looks at to the other; so a strip is as wide as its share says, however far away and however oblique
// the exit is. Where a strip would pass its exit obliquely, its rays turn once before the exit, and then look straight
// through it, as those of PPC1 and PPC3 in Figure 4.18; where the exit lies beside the opening, or looks back, twice.
// Of an exit that is wide the middle alone is entered, so that the image of what comes after is not squeezed.
//
// Strips of a region may cross, so it shows some of its floor twice. Rays end at surfaces; limits only keep them within
// a region's reach (walkBoxesOf()).
//
// A fan is level where openings are: a ray along the top of the entry runs to the top of the exit, as far as the exit
// is no taller. So what lies beyond takes the upper part of the image, and the floor before it the lower.
//
// DEVIATION: the text's crossings have right angles, and one exit to a side; these have any number at any angle.
#pragma once

#include <functional>
#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/constructor/walk_fans.h"
#include "oc_core/constructor/walk_region.h"

namespace ocelli {

/// By which way rays go on to an exit.
struct PieceLane {
  double aside = 0;     ///< which part of the exit they pass: -1 its left, 0 its middle, 1 its right
  double around = 0;    ///< how far they swerve half way there, to the right, in lengths of the way
  double before = 1;    ///< how far before the exit they turn to it, in its widths
  double straight = 0;  ///< how far they go straight on first, in widths of the entry: past the open leaf of a door
  double into = 0.4;    ///< how far into the region, in its depths, where the exit lies beside the entry
  double top = 1;       ///< up to which share of the exit's height they go: less looks down to stairs
};

/// An exit that rays go on to.
struct PieceExit {
  WalkMouth mouth;
  double weight = 1;  ///< of what comes after it
  PieceLane lane{};
};

/// What reaches an exit.
struct PieceRays {
  int frustum = -1;  ///< whose rays do; -1 for none
  int first = -1;    ///< through which they come into the region: that or one before it
  WalkMouth mouth;   ///< as much of it as they see
  size_t turns = 0;  ///< of them
};

struct PieceSharing {
  double ownWeight = 1;   ///< of the region itself, times `nearness`
  double evenness = 0.8;  ///< of shares between exits: 1 as the weights, 0 equal
};

struct PieceFans {
  std::vector<PieceRays> exits;  ///< of each exit
  std::vector<int> frusta;       ///< of the region
};

/// Adds the frusta for the rays of `frustum` that come in by `entry`. `border` is the region, or what lies ahead of the
/// entry.
PieceFans addPiece(GraphCamera& camera, const WalkRegion& region, const PlanPolygon& border, int frustum,
                   const WalkMouth& entry, const std::vector<PieceExit>& exits, const PieceSharing& sharing);

}  // namespace ocelli
