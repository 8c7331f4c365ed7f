// The comprehensive camera (sections 4.3.2.2 and 7.2, Figures 4.25 and 4.27): a graph camera that shows a whole maze in
// one image, each place once. It begins before the entrance and follows a tour (maze_tour.h): at a turn its rays bend,
// at a crossing they split (crossing_frusta.h), and they end where another leg has the next cell.
//
// Who gets how many pixels. A corridor is seen from a viewpoint some way behind its beginning: the farther, the less of
// the image its own walls and floor take, and the more is left for what comes after. The share of the area of the image
// that goes on from a leg of m cells to the n cells after it is n / (n + k m), k being `nearness`. At a crossing the
// shares are as the cells after it to the power `evenness`.
//
// All viewpoints are at the height of the tops of the walls: rays run level or down, and what does not go on shows the
// floor before. So the upper border of the image is the horizon, and objects are seen from above.
#pragma once

#include <optional>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/constructor/maze_tour.h"

namespace ocelli {

class JsonFields;

struct ComprehensiveOptions {
  TourOrder order = TourOrder::kBreadthFirst;
  std::optional<MazeCell> start;     ///< instead of the entrance
  std::optional<Direction> heading;  ///< into the start; given with it, and only with it
  double eyeHeight = 2;              ///< of all viewpoints, in heights of the walls; at least 1
  double nearness = 1.5;             ///< more shows what is near larger
  double evenness = 0.8;             ///< 0 gives ways equal shares, 1 shares by the cells that they lead to
};

/// An image of that size. Throws InputError where the start is not in the maze, where a wall stands behind or before
/// it, and where the image is too small for the maze, or a way has more turns than a graph camera takes.
GraphCamera makeComprehensiveCamera(const Maze& maze, const ComprehensiveOptions& options, int width, int height);

/// Throws InputError for fields that are wrong.
ComprehensiveOptions readComprehensiveOptions(JsonFields& fields);

}  // namespace ocelli
