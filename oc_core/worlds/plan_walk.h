// What the plans of made scenes share when they say where one can walk: openings between boxes, and ways through them.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/scene/walk_map.h"

namespace ocelli {

/// A cell over the rectangle between two corners in (x, z), level; its axis runs along its longer side, to the east or
/// to the north.
WalkCell levelCell(WalkCellKind kind, const glm::vec2& lower, const glm::vec2& upper, float floor, float height);

/// The corners in (x, z) of a cell whose axis is along x or z.
struct CellFootprint {
  glm::vec2 lower{0};
  glm::vec2 upper{0};
};
CellFootprint footprintOf(const WalkCell& cell);

/// An upright opening on the floor at `place`; `normal` is level.
Portal uprightOpening(const glm::vec3& place, const glm::vec3& normal, float halfWidth, float height);

/// Adds an opening wherever two cells of one level touch along an edge for at least `minWidth`, as high as the lower
/// one of them; it is seen from the one with the larger floor. For cells that nothing parts but their edges.
void openTouchingCells(WalkMap& map, float minWidth);

/// The cells of a shortest way by the number of portals, both ends included, and the portals between them; empty where
/// there is none.
struct CellWay {
  std::vector<size_t> cells;
  std::vector<size_t> portals;
};
CellWay wayThroughCells(const WalkMap& map, size_t from, size_t to);
/// The cell farthest from one by the number of portals, of several the first.
size_t farthestCell(const WalkMap& map, size_t from);

/// The way as a line through the middles of its cells and openings, `eyeHeight` over their floors.
std::vector<glm::vec3> lineOfWay(const WalkMap& map, const CellWay& way, float eyeHeight);

}  // namespace ocelli
