// The comprehensive camera (section 4.3.2.2) for any scene with a walk map: a graph camera that shows the cells that
// can be reached from a start in one image, each once, as far as its size allows; and which it does not show, and why.
//
// It follows a tour, a tree of cells (walk_tour.h). Its rays come into a cell through an opening, and part there: each
// opening to a next cell gets a strip, and the walls between get the rest, which shows the cell itself (walk_piece.h).
// Rays end at surfaces, so what stands around a cell is seen however well its box fits, and a place that two strips
// reach is seen twice; project() gives one of both, and its t.
//
// Who gets how many pixels. Of the rays that come into a cell of weight a, with cells of the weight n after it, about
// the share n / (n + k a) goes on, k being `nearness`; between openings shares are as the weight after each to the
// power `evenness`. Weights are the floors at first, evened out. The camera is built again and again with weights that
// give more to cells whose middles have fewer pixels than others, and the one that lacks least is taken.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/constructor/maze_tour.h"
#include "oc_core/render/raycast.h"
#include "oc_core/scene/walk_map.h"

namespace ocelli {

struct WalkStart {
  uint32_t cell = 0;             ///< of WalkMap::cells
  glm::dvec3 heading{0, 0, -1};  ///< level: rays come in along it, from the side of the cell that lies behind
};

struct WalkComprehensiveOptions {
  TourOrder order = TourOrder::kBreadthFirst;
  std::optional<WalkStart> start{};  ///< nothing: of those with short ways the one that shows most
  double nearness = 1.5;             ///< more shows what is near larger
  double evenness = 0.8;             ///< 0 gives ways equal shares, 1 shares by the floor that they lead to
  double eyeHeight = 1;  ///< of what is seen through openings, in their heights; more sees over walls without a ceiling
  double minPixels = 4;  ///< that the middle of each cell should have
  int builds = 16;       ///< of which the best is taken
};

/// Why a cell is not seen.
enum class WalkUnseen : uint8_t {
  kNothing,       ///< it is seen
  kNoWay,         ///< no opening leads there from the start
  kNoFloor,       ///< its box has no area
  kTooManyTurns,  ///< of rays, more than a graph camera takes
  kNoRays,        ///< none come in: those that reach the cell before it pass its opening by
  kTooFewPixels,  ///< the image is too small for it
  kHidden,        ///< something stands before it, or in the way of its rays
};
/// "no way leads there from the start".
const char* textOf(WalkUnseen why);

/// Of a cell, in a comprehensive image.
struct WalkCellView {
  WalkUnseen unseen = WalkUnseen::kNothing;
  int parent = -1;    ///< the cell before it on the tour; -1 for the start and where there is none
  size_t turns = 0;   ///< bends of its rays
  double pixels = 0;  ///< of its middle (middleOf) on the floor, whatever stands before it
  double seenPixels =
      0;              ///< those of them that show it, by rays: all cast where they are few; without a scene `pixels`
  int hiddenIn = -1;  ///< where it is hidden, the cell in which most of its rays end
  std::optional<glm::dvec2> center{};  ///< the pixel of its centre on the floor
};

struct ComprehensiveWalk {
  GraphCamera camera;
  WalkStart start;
  std::vector<WalkCellView> cells;  ///< of each cell of the map
  std::vector<int> cellOfFrustum;   ///< of each frustum of the camera; that of the start for its root
};

/// An image of that size. With the rays of the scene, in the units of the map, the report tells what is really seen,
/// and lanes and starts are chosen by that; without, what would be seen of empty boxes. Throws InputError where the map
/// has no cells, for a start that is not one of them, and for options out of range. The report lists the cells that it
/// cannot show.
ComprehensiveWalk makeComprehensiveWalk(const WalkMap& map, const WalkComprehensiveOptions& options, int width,
                                        int height, const RayScene* scene = nullptr);

}  // namespace ocelli
