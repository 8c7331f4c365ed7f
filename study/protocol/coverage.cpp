#include "study/protocol/coverage.h"

#include <algorithm>

#include "oc_core/render/identity_image.h"
#include "study/task/trial_image.h"

namespace ocelli {
namespace {

constexpr uint32_t kObject = 1;  // of a scene with a single one

void addSightings(const std::string& place, const TrialLayout& layout, ViewCoverage& coverage) {
  int sightingsHere = 0;
  size_t largest = 0;
  for (const TrialLayout::View& view : layout.views) {
    for (const ObjectSighting& each : sightings(objectsIn(layout, view))) {
      if (each.object == kObject && each.pixels >= kMinSeenPixels) {
        ++sightingsHere;
        largest = std::max(largest, each.pixels);
      }
    }
  }
  coverage.images = static_cast<int>(layout.views.size());
  ++coverage.places;
  coverage.sightings += sightingsHere;
  if (sightingsHere == 0) {
    coverage.unseen.push_back(place);
    return;
  }
  coverage.fewestPixels = coverage.seen == 0 ? largest : std::min(coverage.fewestPixels, largest);
  ++coverage.seen;
  coverage.twice += sightingsHere > 1 ? 1 : 0;
}

struct Place {
  std::string name;
  glm::vec3 point{0};
};

/// The middle of every cell but the entrance, and of every passage between cells.
std::vector<Place> placesOf(const Maze& maze) {
  std::vector<Place> places;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      if (cell != maze.entrance->cell) {
        places.push_back({nameOf(cell), maze.centerOf(cell)});
      }
      for (const Direction way : {Direction::kEast, Direction::kSouth}) {
        if (maze.isOpen(cell, way)) {
          const MazeCell next = cell.neighbor(way);
          places.push_back({std::string("between ").append(nameOf(cell)).append(" and ").append(nameOf(next)),
                            (maze.centerOf(cell) + maze.centerOf(next)) / 2.0f});
        }
      }
    }
  }
  return places;
}

/// Puts one object, of the shape that the layout's scene has, in each place.
ViewCoverage coverageOfMaze(TrialLayout layout, TrialView view) {
  Maze maze = layout.scene->maze();
  const MazeCell first = maze.landmarks.empty() ? maze.entrance->cell : maze.landmarks.front().cell;
  Landmark object;
  object.cell = first;
  object.shape = maze.landmarks.empty() ? LandmarkShape::kSphere : maze.landmarks.front().shape;
  maze.landmarks = {object};
  const StudyScene scene(maze);
  layout.scene = &scene;
  ViewCoverage coverage;
  coverage.view = view;
  for (const Place& place : placesOf(maze)) {
    layout.objectOffsets = {place.point - maze.centerOf(first)};
    addSightings(place.name, layout, coverage);
  }
  return coverage;
}

TrialPlan planOf(const ProtocolBlock& block, int caseIndex, TrialView view) {
  TrialPlan plan;
  plan.task = block.taskName;
  plan.caseIndex = caseIndex;
  plan.view = view;
  return plan;
}

}  // namespace

std::vector<BlockCoverage> coverageOf(const Protocol& protocol, const TrialScreen& screen, const Progress& progress) {
  std::vector<BlockCoverage> blocks;
  for (size_t i = 0; i < protocol.blocks.size(); ++i) {
    const ProtocolBlock& block = protocol.blocks[i];
    BlockCoverage coverage;
    coverage.block = block.name;
    coverage.ofCases = !block.task->caseInfo(0).exposureSeconds.has_value();
    for (const TrialView view : protocol.conditions.names.all()) {
      const std::unique_ptr<TrialRun> run = block.task->start(planOf(block, 0, view), screen);
      const TrialLayout first = run->layout();
      if (first.scene == nullptr || first.views.empty() || (coverage.ofCases && !first.targetObject)) {
        continue;
      }
      if (!coverage.ofCases) {
        coverage.views.push_back(coverageOfMaze(first, view));
        continue;
      }
      ViewCoverage cases;
      cases.view = view;
      for (int k = 0; k < block.task->caseCount(); ++k) {
        const std::unique_ptr<TrialRun> each = block.task->start(planOf(block, k, view), screen);
        addSightings(block.task->caseInfo(k).label, each->layout(), cases);
      }
      coverage.views.push_back(cases);
    }
    if (!coverage.views.empty()) {
      blocks.push_back(coverage);
    }
    report(progress, "coverage", static_cast<double>(i + 1) / static_cast<double>(protocol.blocks.size()));
  }
  return blocks;
}

}  // namespace ocelli
