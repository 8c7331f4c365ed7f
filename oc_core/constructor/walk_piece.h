// How all rays that come into a region go on to its exits and its walls, as frusta of a graph camera (walk_fans.h).
//
// Rays do not turn back: for exits beside the opening that rays come in by, or so far aside that they would be seen
// almost edge on, the region is parted. Rays come into the part beside through the line that parts it, and see from
// there straight on.
//
// A fan is level where openings are: a ray along the top of the entry runs to the top of the exit, as far as the exit
// is no taller. So what lies beyond takes the upper part of the image, and the floor before it the lower.
#pragma once

#include <functional>
#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/constructor/walk_fans.h"
#include "oc_core/constructor/walk_region.h"

namespace ocelli {

/// An exit that rays go on to.
struct PieceExit {
  WalkMouth mouth;
  double weight = 1;  ///< of what comes after it
};

/// What reaches an exit.
struct PieceRays {
  int frustum = -1;  ///< whose rays do; -1 for none
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
