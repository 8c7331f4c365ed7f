#include "study/task/hidden_cells.h"

#include <algorithm>

#include "oc_core/base/check.h"
#include "oc_core/render/identity_image.h"
#include "study/task/task_layout.h"
#include "study/task/trial_image.h"

namespace ocelli {
namespace {

// The shape of 1920 x 1200, with half of its pixels along each side: what shows with ten pixels or more there shows
// here.
constexpr TrialScreen kSightScreen{1024, 640, 60};

struct Reached {
  int steps = 0;
  MazeCell cell;
};

std::vector<Reached> reachedFrom(const Maze& maze, const MazeCell& start) {
  const std::vector<std::optional<int>> steps = maze.shortestStepsFrom(start);
  std::vector<Reached> reached;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      if (const std::optional<int> far = steps[maze.indexOf(cell)]; far && cell != start) {
        reached.push_back({*far, cell});
      }
    }
  }
  std::stable_sort(reached.begin(), reached.end(),
                   [](const Reached& a, const Reached& b) { return a.steps < b.steps; });
  return reached;
}

/// The objects that a view shows, from 0.
std::vector<size_t> seenIn(const TrialLayout& layout) {
  std::vector<size_t> seen;
  for (const TrialLayout::View& view : layout.views) {
    for (const ObjectSighting& each : sightings(objectsIn(layout, view))) {
      seen.push_back(each.object - 1);
    }
  }
  return seen;
}

}  // namespace

std::vector<MazeCell> hiddenCells(const Maze& maze, const SightSetting& setting) {
  const glm::vec3 eye(glm::dvec3(setting.start.x, 0, setting.start.z));
  const std::optional<MazeCell> start = maze.cellAt(eye);
  OC_CHECK(start.has_value(), "one starts in a cell");
  const std::vector<Reached> reached = reachedFrom(maze, *start);
  // All of them at once. What is seen goes away, so that what it hid can be seen; and so on, until nothing is.
  Maze withObjects = maze;
  withObjects.landmarks.clear();
  for (const Reached& each : reached) {
    withObjects.landmarks.push_back(setting.object);
    withObjects.landmarks.back().cell = each.cell;
  }
  const StudyScene scene(withObjects);
  TrialLayout layout;
  layout.scene = &scene.bare();
  layout.objectOffsets.assign(reached.size(), glm::vec3(0));
  std::vector<bool> isSeen(reached.size(), false);
  const glm::vec3 away(0, -1000 * maze.wallHeight, 0);
  for (const TrialView view : setting.camera.conditions().names.all()) {
    layout.views = setting.camera.views(setting.start, view, stageOf(kSightScreen));
    for (bool more = true; more;) {
      more = false;
      for (const size_t object : seenIn(layout)) {
        more = more || layout.objectOffsets[object] != away;
        isSeen[object] = true;
        layout.objectOffsets[object] = away;
      }
    }
  }
  std::vector<MazeCell> hidden;
  for (size_t i = 0; i < reached.size(); ++i) {
    if (!isSeen[i]) {
      hidden.push_back(reached[i].cell);
    }
  }
  return hidden;
}

std::vector<MazeCell> cellsOfBand(const std::vector<MazeCell>& nearestFirst, int band, int bands) {
  OC_CHECK(band >= 0 && band < bands, "a band is one of them");
  const auto size = static_cast<std::ptrdiff_t>(nearestFirst.size());
  return {nearestFirst.begin() + size * band / bands, nearestFirst.begin() + size * (band + 1) / bands};
}

}  // namespace ocelli
