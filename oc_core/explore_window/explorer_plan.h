// What the plan of the window shows of an explorer: the ground from above, cells of the walk map, openings, frusta.
#pragma once

#include <memory>
#include <optional>

#include "oc_core/explore/explorer.h"
#include "oc_core/explore_window/explore_window_model.h"

namespace ocelli {

/// The scene from above, below the height `cut`, so that one looks into rooms. Dark, so that what is drawn over it is
/// seen. Of the camera's rays, those from far away: perspective is slight.
WindowGround groundBelow(const ExploreScene& scene, float cut);

/// The outlines of cells; those of tunnels follow their rings.
std::vector<WindowPlan::Cell> planCells(const WalkMap& map);

/// The openings that are known, each once.
std::vector<WindowPlan::Opening> planOpenings(const ExploreScene& scene);
std::vector<glm::vec2> planPath(const ExploreScene& scene);

/// What changes from frame to frame.
WindowPlan planOfExplorer(const Explorer& explorer);

}  // namespace ocelli
