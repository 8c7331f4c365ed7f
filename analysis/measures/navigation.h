// How subjects moved in searches, from the log of where they stood: way and detour, turns, when the object came into
// sight, and where in the maze the time went.
//
// What the log does not tell is said to be unknown: where a moving object was, what a CSV export does not hold, and
// what bent rays showed. For the latter, "in sight" means what a pinhole of the same eye would have shown; a view with
// bent rays may have shown the object earlier.
#pragma once

#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/dataset/dataset.h"
#include "analysis/measures/walk.h"

namespace ocelli {

struct SearchNavigation {
  size_t trial = 0;  ///< index into Dataset::trials
  WalkMeasures walk;
  bool objectIsKnown = false;                ///< where it stood; then, without travelSeconds, it never was in sight
  Estimable<double> shortestToEndMeters;     ///< from cell to cell between the first and the last pose
  Estimable<double> detour;                  ///< walked over that
  Estimable<double> shortestToObjectMeters;  ///< from the first cell to the object's
  Estimable<double> walkedOverWayToObject;   ///< below 1 where one saw it from afar
  // Search = travel + detection.
  Estimable<double> travelSeconds;     ///< to the first time in straight sight
  Estimable<double> detectionSeconds;  ///< from then to the click
};

/// Seconds spent over the cells of a maze.
struct MazeHeatMap {
  int source = 0;  ///< whose protocol draws the maze
  std::string maze;
  TrialView view = TrialView::kReference;
  bool moving = false;  ///< the object
  int rows = 0;
  int columns = 0;
  std::vector<double> seconds;  ///< row by row
  int64_t trials = 0;
  double secondsOutside = 0;  ///< of poses that lie outside of the maze
};

struct NavigationData {
  std::vector<SearchNavigation> searches;
  std::vector<MazeHeatMap> heatMaps;  ///< by maze, moving, view
  int64_t searchesWithoutLog = 0;     ///< the generator's, those of tables
  std::vector<std::string> notes;     ///< whole sentences
};

/// Of all trials of a task that is a search. Reads the logs trial by trial. Throws InputError.
NavigationData navigationOf(const Dataset& data, const std::string& task);

}  // namespace ocelli
