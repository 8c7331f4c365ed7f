// A plan of where one can walk in a scene, as Figure 4.17 shows a maze: cells, tunnels with their rings, and portals,
// over a section of the scene.
#pragma once

#include <string>

#include "oc_core/drawing/figure.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/scene/walk_map.h"

namespace ocelli {

struct WalkPlanOptions {
  std::string title{};
  float cutHeight = 1.2f;  ///< of the section, over the lowest floor
  int planPixels = 1200;   ///< longer side of the plan, in points of an SVG
};

/// Rooms are filled, tunnels too and with their rings across, portals are thick lines; each part that cannot be reached
/// from the others has colours of its own. North, -z, is at the top.
Figure walkPlanFigure(const WalkMap& map, const Mesh& mesh, const WalkPlanOptions& options = {});

}  // namespace ocelli
