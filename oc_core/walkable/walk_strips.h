// Areas divided where strips of floor cross, turn and end: crossings, and the corridors and streets between them.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/walkable/walk_areas.h"

namespace ocelli {

/// What a piece of the floor is.
struct WalkShape {
  bool isTunnel = false;
  bool isAlongX = false;   ///< of a tunnel: else along z
  bool isOfWays = false;   ///< of a street or corridor: a tunnel, a crossing, a turn or a dead end
  uint16_t halfWidth = 1;  ///< of its area
};

/// The axis of a tunnel in the plan; zero for a room, whose box chooses it.
inline glm::dvec2 givenAxis(const WalkShape& shape) {
  return !shape.isTunnel ? glm::dvec2(0) : shape.isAlongX ? glm::dvec2(1, 0) : glm::dvec2(0, 1);
}

struct WalkLayout {
  WalkPieces pieces;
  std::vector<WalkShape> shapes;  ///< of each piece
};

/// What is between crossings (walk_crossings.h) are tunnels; an area without crossings is one where it is 2.5 times as
/// long as wide. Tunnels that go on in each other are one: what parts them, such as an arch, becomes rings. The last
/// square of a tunnel with a closed end is a room, the dead end. A tunnel is divided where another one opens into its
/// side. `radius` is that of the agent, in squares.
WalkLayout layoutOf(const WalkField& field, const WalkAreas& areas, int radius);

}  // namespace ocelli
