// Where one can walk in any scene, from its geometry alone: the maze of section 4.3.1.4 without someone to draw it.
//
// 1. The scene is turned about the vertical until most of its walls stand along the axes (walk_direction.h).
// 2. Its triangles are rasterised to columns of solid spans by Recast (walk_columns.h).
// 3. Floors on which the agent can stand become squares that know their neighbours, on any number of storeys
//    (walk_field.h); what the agent cannot get to, and gaps that are too narrow, are left out (walk_reach.h).
// 4. Small obstacles, such as lamps in a street, are overlooked (walk_obstacles.h).
// 5. The width of the free space at each square (walk_width.h) divides the floor into areas: doors are narrow, rooms
//    and streets have a width of their own (walk_areas.h).
// 6. Areas that are longer than wide are divided where they cross or turn (walk_strips.h).
// 7. Pieces of one room are joined (walk_joints.h, walk_rooms.h).
// 8. Each piece becomes a box, or a tunnel with rings (walk_cells.h), and their borders become portals
//    (walk_portals.h): openings between rooms, and joints within them.
//
// DEVIATION: the dissertation fits boxes by hand ("The maze is built by fitting rectangular boxes to path
// intersections"); all the rules here are ours.
//
// The same scene gives the same map, whatever the number of threads.
#pragma once

#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/walk_map.h"
#include "oc_core/walkable/walk_options.h"

namespace ocelli {

/// Whether this program was built with Recast (OCELLI_WITH_RECAST).
bool canFindWalkable();

/// A map, and what was left out of it and why. Areas are in square units of the scene.
struct WalkSurvey {
  WalkMap map;
  double directionDegrees = 0;  ///< of most walls, from the x axis towards -z; 0 to 90, without 90
  double cellSize = 0;          ///< of the height field: larger than asked for where the scene is too large
  double floorArea = 0;         ///< of the map
  double tooNarrowArea = 0;     ///< floor where the agent fits in height, and not in width
  double smallPartsArea = 0;    ///< floor of parts that were left out, being small and out of reach
  size_t smallParts = 0;
  std::vector<std::string> notes;  ///< what the user should know, a sentence each
};

/// Throws InputError where there is no floor, where no floor is large enough for the agent, where options are out of
/// range, and where the program was built without Recast. `mesh` must be valid.
WalkSurvey surveyWalkable(const Mesh& mesh, const WalkOptions& options, const Progress& progress = {});

/// The map alone.
WalkMap findWalkMap(const Mesh& mesh, const WalkOptions& options, const Progress& progress = {});

/// Sets the walk map of the guides where they have none, for a person. `source` is what the scene was loaded from.
/// Returns what the user should know, a sentence each.
std::vector<std::string> findWays(const std::string& source, GuidedScene& scene, const Progress& progress = {});

}  // namespace ocelli
