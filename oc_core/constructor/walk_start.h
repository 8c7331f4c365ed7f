// Where a camera that shows all cells of a walk map begins: almost parallel rays that come into its first cell from one
// side, over as much of it as an image of this shape shows.
#pragma once

#include "oc_core/camera/graph_camera.h"
#include "oc_core/constructor/walk_comprehensive.h"
#include "oc_core/constructor/walk_region.h"

namespace ocelli {

struct WalkBeginning {
  GraphCamera camera;  ///< its root is the bundle
  WalkMouth entry;     ///< within the cell, at its side
  PlanPolygon ahead;   ///< what of the cell lies ahead of it
};

/// `tall` is the height of the image of the entry, in heights of the cell; `reach` about how long rays get.
WalkBeginning beginWalk(const WalkRegion& region, const WalkStart& start, double tall, double reach, int width,
                        int height);

/// Where most floor is reached, the cells and the sides from which all others are few steps away; a side
/// without openings, where there is one.
/// The best of them come first; at most so many. None where no cell has floor.
std::vector<WalkStart> chooseWalkStarts(const WalkMap& map, const std::vector<WalkRegion>& regions, size_t most);
/// The best side of that cell.
WalkStart chooseWalkSide(const WalkMap& map, const std::vector<WalkRegion>& regions, uint32_t cell);

}  // namespace ocelli
