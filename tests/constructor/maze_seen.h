// What an image of a whole maze shows of it: pixels of each cell and object, and whether anything is seen twice.
//
// "Seen exactly once" means, of an object: at least one pixel of the identity image shows it; every pixel that shows it
// has a surface point that the camera projects back onto that pixel, so that no two pixels show the same point (the
// projection of a point is unique); and these pixels are one connected region. Where they are not, what is nearer may
// hide what joins them: then the object alone, all else taken out of the scene, must be one region.
#pragma once

#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/scene/maze.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli::test {

/// A maze of a size and share of loops that follow from the seed, from 6 x 6 to 10 x 10 cells, with landmarks and as
/// many balls and boxes again at random places of corridors, none in another.
struct MazeWithObjects {
  explicit MazeWithObjects(uint64_t seed);

  Maze maze;
  GuidedScene scene;
  size_t objects = 0;  ///< identities 1 to this
};

struct SeenMaze {
  std::vector<size_t> cellPixels;    ///< whose point is in the clear box of the cell
  std::vector<size_t> objectPixels;  ///< of identity i + 1
  std::vector<size_t> regions;       ///< connected ones of each object, those that others part counted as one
  /// Renderers draw surfaces up to 1/64 pixel beyond the planes where rays end (straight_segment.h), so of the pixels
  /// beside such an edge one in 64 is stray.
  size_t strayObjectPixels = 0;  ///< whose point projects elsewhere, or nowhere
  size_t strayPixels = 0;        ///< the same of a seventh of all that shows floor and walls
  double worstReturn = 0;        ///< pixels, of the others
};

/// The scene has objects with identities 1 to `objects`.
SeenMaze seenMaze(const GraphCamera& camera, const Maze& maze, const GuidedScene& scene, size_t objects);

}  // namespace ocelli::test
