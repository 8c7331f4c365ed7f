// What a simulated subject gets of one frame of a trial: all that it ever learns of the scene.
//
// Everything in it is worked out from the identity image of the screen: which object, or which piece of floor, each
// pixel shows. What a subject is spared, and a person is not: it knows any piece of floor that it sees for what it is,
// in straight views and in bent ones, as one does who knows the plan of what one looks at; and it knows from what it
// sees where it stands. What it does not know is told nowhere: walls and ways that it has not seen, and objects.
#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "oc_core/scene/maze.h"
#include "study/agent/picture_perspective.h"
#include "study/task/task.h"

namespace ocelli {

/// One object as it shows in one view: pixels that touch each other, or nearly.
struct Sighting {
  LandmarkShape shape = LandmarkShape::kCone;
  LandmarkColor color = LandmarkColor::kOrange;
  int view = 0;  ///< of the layout, from 0
  size_t pixels = 0;
  glm::dvec2 lower{0};     ///< of the screen, pixels
  glm::dvec2 upper{0};     ///< likewise
  glm::dvec2 centroid{0};  ///< likewise
  glm::dvec2 aim{0};       ///< the middle of its pixel nearest to the centroid
  glm::dvec2 place{0};     ///< east and south, metres: the mean of what shows of it
  /// How the picture shows the floor around it, where that can be told.
  std::optional<PicturePerspective> perspective{};
};

/// A ninth of the floor of a cell, or the floor between two cells where no wall stands: pixels show it, or what lies
/// behind it so low that nothing stands on it.
struct FloorPatch {
  MazeCell cell;
  int ninth = 0;  ///< row by row from the north-west
  /// Not a ninth, but the way from the cell to the east or south.
  std::optional<Direction> way{};
  int view = 0;
  size_t pixels = 0;
  glm::dvec2 centroid{0};  ///< of the screen, pixels
  glm::dvec2 place{0};     ///< the mean of what shows of it, east and south, metres
  bool straight = true;    ///< seen along rays that do not bend: nothing stands between
};

/// A small piece of floor or wall, which one knows again a moment later by what is on it.
struct SurfaceSpot {
  glm::ivec3 cube{0};      ///< of space, with edges of a quarter of a cell, that holds it
  glm::dvec2 centroid{0};  ///< of the screen, pixels
};

/// A map to choose, its corners in its own metres.
using SeenMap = TrialLayout::PathMap;
using SeenChoice = TrialLayout::Choice;
using SeenScale = TrialLayout::Scale;
using SeenDial = TrialLayout::Dial;

/// The grid that floors are seen to lie in.
struct SeenGrid {
  glm::dvec2 origin{0};  ///< of row 0 and column 0, east and south, metres
  double cellSize = 1;
  uint64_t surroundings = 0;  ///< tells mazes apart: one knows whether one has been here before

  glm::dvec2 middleOf(const MazeCell& cell) const {
    return origin + (glm::dvec2(cell.column, cell.row) + 0.5) * cellSize;
  }
  MazeCell cellAt(const glm::dvec2& place) const {
    const glm::dvec2 p = glm::floor((place - origin) / cellSize);
    return {static_cast<int>(p.y), static_cast<int>(p.x)};
  }
};

struct Percept {
  std::vector<PixelRect> views;
  SeenGrid grid;  ///< of the views
  /// Where the view looks from, where there is but one that moves with the subject: one knows it by what one sees.
  std::optional<WalkerPose> standing{};
  std::vector<Sighting> objects;
  std::vector<FloorPatch> floor;
  std::vector<SurfaceSpot> surfaces;  ///< in the order of their cubes
  /// What is sought, as it is shown beside the prompt.
  std::optional<LandmarkShape> soughtShape{};
  std::optional<LandmarkColor> soughtColor{};
  std::vector<SeenMap> maps;
  std::vector<SeenChoice> choices;
  std::optional<SeenScale> scale{};
  std::optional<SeenDial> dial{};
  std::optional<glm::dvec2> pointer{};
};

}  // namespace ocelli
