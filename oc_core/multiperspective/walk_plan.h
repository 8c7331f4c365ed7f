// A plan of where one can walk in a scene, as Figure 4.17 shows a maze: cells, tunnels with their rings, and portals,
// over a section of the scene.
#pragma once

#include <optional>
#include <string>

#include "oc_core/drawing/figure.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/scene/walk_map.h"

namespace ocelli {

struct WalkPlanOptions {
  std::string title{};
  /// Of the floor that is shown: cells whose floor, from its beginning to its end, comes within half a metre of it. All
  /// cells, and the section of the lowest floor, where it is missing.
  std::optional<float> floor{};
  float metre = 1;         ///< in units of the scene
  float cutHeight = 1.2f;  ///< metres, of the section over the floor
  int planPixels = 1200;   ///< longer side of the plan, in points of an SVG
};

/// Rooms are filled, tunnels too and with their rings across, openings are thick lines and joints thin ones; cells have
/// their numbers, those of WalkMap::cells; each part that cannot be reached
/// from the others has colours of its own. North, -z, is at the top.
Figure walkPlanFigure(const WalkMap& map, const Mesh& mesh, const WalkPlanOptions& options = {});

}  // namespace ocelli
