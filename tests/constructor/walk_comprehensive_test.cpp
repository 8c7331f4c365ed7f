#include "oc_core/constructor/walk_comprehensive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/camera/graph_overlap.h"
#include "oc_core/constructor/comprehensive_constructor.h"
#include "oc_core/constructor/walk_from_maze.h"
#include "oc_core/image/png_file.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/render/raycast.h"
#include "tests/constructor/maze_plans.h"
#include "tests/constructor/maze_seen.h"
#include "tests/constructor/walk_maps.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

/// OCELLI_TEST_IMAGES=FOLDER keeps the image, to be looked at.
void keepImage(const GraphCamera& camera, const Mesh& mesh, const std::string& name) {
  if (const char* folder = std::getenv("OCELLI_TEST_IMAGES")) {
    writePng(std::string(folder) + "/" + name + ".png",
             srgbFromLinear(colorImage(rasterize(camera, mesh), mesh, glm::vec3(0.1f))));
  }
}

size_t countUnseen(const ComprehensiveWalk& walk) {
  size_t unseen = 0;
  for (size_t i = 0; i < walk.cells.size(); ++i) {
    if (walk.cells[i].unseen != WalkUnseen::kNothing) {
      ++unseen;
      std::printf("cell %zu: %s (%.3f pixels, %zu turns)\n", i, textOf(walk.cells[i].unseen), walk.cells[i].pixels,
                  walk.cells[i].turns);
    }
  }
  return unseen;
}

size_t overlapCount(const GraphCamera& camera, const Mesh& mesh) {
  const Box world = boundsOf(mesh);
  const auto overlaps = overlapsOf(camera, glm::dvec3(world.lower), glm::dvec3(world.upper));
  for (const FrustumOverlap& each : overlaps) {
    std::printf("%s and %s overlap at (%g, %g, %g)\n", camera.frusta()[static_cast<size_t>(each.first)].name.c_str(),
                camera.frusta()[static_cast<size_t>(each.second)].name.c_str(), each.point.x, each.point.y,
                each.point.z);
  }
  return overlaps.size();
}

/// Of pixels, those in which rasteriser and ray caster differ.
double differingShare(const GraphCamera& camera, const Mesh& mesh) {
  const FragmentImage drawn = rasterize(camera, mesh);
  const FragmentImage cast = raycast(camera, mesh, RayScene(mesh));
  size_t differing = 0;
  for (size_t i = 0; i < drawn.size(); ++i) {
    differing += drawn[i].covered() != cast[i].covered() || std::abs(drawn[i].t - cast[i].t) > 1e-3f * cast[i].t;
  }
  return static_cast<double>(differing) / static_cast<double>(drawn.size());
}

TEST(ComprehensiveWalk, showsAllCellsOfAHouse) {
  const test::PlannedHouse house = test::smallHouse();
  for (const float degrees : {0.0f, 27.0f}) {
    const GuidedScene scene = house.scene(degrees);
    const ComprehensiveWalk walk = makeComprehensiveWalk(*scene.guides.walk, {}, 960, 600);
    keepImage(walk.camera, scene.mesh, degrees > 0 ? "walk_house_turned" : "walk_house");
    EXPECT_EQ(countUnseen(walk), 0u);
    EXPECT_EQ(overlapCount(walk.camera, scene.mesh), 0u);
    EXPECT_LT(differingShare(walk.camera, scene.mesh), 0.005);
  }
}

TEST(ComprehensiveWalk, showsAllCellsOfGrids) {
  for (const Maze& maze : {test::crossroads(), test::serpentine(5)}) {
    const GuidedScene scene = test::sceneOf(maze);
    const WalkMap map = walkMapOf(maze);
    const ComprehensiveWalk walk = makeComprehensiveWalk(map, {}, 960, 600);
    keepImage(walk.camera, scene.mesh, "walk_grid_" + std::to_string(maze.columns()));
    EXPECT_EQ(countUnseen(walk), 0u);
    EXPECT_EQ(overlapCount(walk.camera, scene.mesh), 0u);
    EXPECT_LT(differingShare(walk.camera, scene.mesh), 0.005);
    const test::SeenMaze seen = test::seenMaze(walk.camera, maze, scene, maze.landmarks.size());
    for (size_t i = 0; i < seen.cellPixels.size(); ++i) {
      EXPECT_GE(seen.cellPixels[i], 4u) << "cell " << i;
    }
  }
}

}  // namespace
}  // namespace ocelli
