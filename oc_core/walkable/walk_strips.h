// Areas divided where strips of floor cross, turn and end: crossings, and the corridors and streets between them.
#pragma once

#include <vector>

#include "oc_core/walkable/walk_areas.h"

namespace ocelli {

/// What a piece of the floor is.
struct WalkShape {
  bool isTunnel = false;
  bool isAlongX = false;   ///< of a tunnel: else along z
  uint16_t halfWidth = 1;  ///< of its area
};

struct WalkLayout {
  WalkPieces pieces;
  std::vector<WalkShape> shapes;  ///< of each piece
};

/// Floor is a crossing where free floor of its area reaches further than 1.5 widths along both axes; what is between
/// crossings are tunnels. An area without crossings is a tunnel where it is 2.5 times as long as wide. The last square
/// of a tunnel with a closed end is a room, the dead end. A tunnel is divided again where another one opens into its
/// side. `radius` is that of the agent, in squares.
WalkLayout layoutOf(const WalkField& field, const WalkAreas& areas, int radius);

}  // namespace ocelli
