// What one sees who travels with a path camera, along a river, streets, corridors and between blocks: how much
// consecutive images differ, beside those of the pinhole that travels along.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/constructor/path_constructor.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_curved.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/town_plan.h"
#include "tests/constructor/image_change.h"

namespace ocelli {
namespace {

struct Travel {
  const char* name;
  const char* scene;
  std::vector<glm::vec3> path;  ///< where empty, that of the scene
  double fovVerticalDegrees;
  double eyeHeight;
  double preview;
  int turns;
  double last;       ///< position where the travel ends, so that the preview is always whole
  double stepShare;  ///< of the path's length
};

std::vector<glm::vec3> throughTheTown() {
  const TownPlan plan = planTown(1);
  const auto at = [&](size_t x, size_t z) {
    return glm::vec3(plan.streetsNorthSouth.at(x), 0, plan.streetsEastWest.at(z));
  };
  return {at(0, 0), at(1, 0), at(1, 1), at(2, 1), at(2, 2), at(1, 2), at(1, 1)};
}

/// Along the corridors of the maze of seed 1, from the entrance on.
std::vector<glm::vec3> throughTheMaze() {
  const GuidedScene scene = loadGuidedScene("builtin:maze,seed=1", {.fit = false});
  const Maze& maze = *scene.guides.maze;
  MazeCell cell = maze.entrance->cell;
  std::vector<glm::vec3> path{maze.centerOf(cell)};
  Direction heading = maze.entrance->heading;
  for (int i = 0; i < 16; ++i) {
    std::vector<Direction> ways = maze.passages(cell);
    if (i > 0) {
      std::erase(ways, opposite(heading));
    }
    if (ways.empty()) {
      break;  // a dead end
    }
    heading = ways.back();
    cell = cell.neighbor(heading);
    path.push_back(maze.centerOf(cell));
  }
  return path;
}

std::vector<glm::vec3> betweenTheBlocks() {
  std::vector<glm::vec3> path;
  for (int i = 0; i <= 60; ++i) {
    const float t = static_cast<float>(i) / 60;
    path.emplace_back(0.9f * t - 0.45f, 0, 0.12f * std::sin(12 * t));
  }
  return path;
}

std::vector<Travel> travels() {
  return {
      {"canyon", "builtin:canyon", {}, 40, 45, 0.25, 4, 0.75, 1.0 / 600},
      {"town", "builtin:town", throughTheTown(), 50, 1.7, 0.2, 4, 0.5, 1.0 / 300},
      {"maze", "builtin:maze,seed=1", throughTheMaze(), 60, 1.5, 0.25, 4, 0.75, 1.0 / 480},
      {"blocks", "builtin:boxes,count=700,floor=1", betweenTheBlocks(), 50, 0.25, 0.3, 3, 0.7, 1.0 / 400},
  };
}

class PathTravel : public testing::TestWithParam<size_t> {};

TEST_P(PathTravel, noFrameJumpsByMoreThanThePinholes) {
  const Travel travel = travels().at(GetParam());
  const GuidedScene scene = loadGuidedScene(travel.scene, {.fit = std::string(travel.name) == "blocks"});
  View view;
  view.fovVerticalDegrees = static_cast<float>(travel.fovVerticalDegrees);
  view.zNear = 0.0005f * glm::length(boundsOf(scene.mesh).size());
  view.zFar = 2 * glm::length(boundsOf(scene.mesh).size());
  constexpr int kPathSamples = 2;
  const PinholeCamera reference(view, 160 * kPathSamples, 90 * kPathSamples);
  const MeshBlocks blocks(scene.mesh);
  PathOptions options;
  options.path = travel.path;
  options.preview = travel.preview;
  options.turns = travel.turns;
  options.eyeHeight = travel.eyeHeight;
  test::ImageChange ofPinhole(kPathSamples);
  test::ImageChange ofCamera(kPathSamples);
  std::vector<double> ratios;
  double pinhole = 0;
  double camera = 0;
  double where = 0;
  size_t turns = 0;
  for (options.position = 0; options.position < travel.last; options.position += travel.stepShare) {
    const CurvedRayCamera curved = buildPathCamera(options, scene.guides, reference);
    turns += curved.bends().size();
    const auto one = ofPinhole.next(rasterize(curved.root(), scene.mesh), scene.mesh);
    const auto other = ofCamera.next(rasterize(curved, scene.mesh, blocks), scene.mesh);
    if (one) {
      ratios.push_back(*other / std::max(*one, 1e-9));
      pinhole = std::max(pinhole, *one);
      where = *other > camera ? options.position : where;
      camera = std::max(camera, *other);
    }
  }
  test::report(std::string(travel.name) + ": camera / pinhole, each of the steps", ratios);
  std::printf("%s: largest step: camera %.4f (at %.4f), pinhole %.4f; %.2f turns a frame\n", travel.name, camera, where,
              pinhole, static_cast<double>(turns) / static_cast<double>(ratios.size() + 1));
  EXPECT_GT(turns, ratios.size());
  EXPECT_LE(camera, pinhole);
}

INSTANTIATE_TEST_SUITE_P(Travels, PathTravel, testing::Range<size_t>(0, 4),
                         [](const auto& each) { return travels().at(each.param).name; });

}  // namespace
}  // namespace ocelli
