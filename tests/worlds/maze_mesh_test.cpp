#include "oc_core/worlds/maze_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/random.h"
#include "oc_core/scene/winding_number.h"
#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/landmark_solids.h"
#include "oc_core/worlds/maze_file.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/mesh_checks.h"
#include "tests/worlds/random_mazes.h"

namespace ocelli {
namespace {

TEST(MazeMesh, IsAClosedSolidOfTheVolumeOfItsWalls) {
  for (uint64_t seed = 0; seed < 30; ++seed) {
    const Maze maze = generateMaze(test::mazeOptions(seed));
    const Mesh structure = makeMazeScene(maze).meshes.at(0);
    EXPECT_TRUE(isClosed(structure)) << seed;
    // Each of the (rows + 1)(columns + 1) posts, and each wall that stands: all but the gap and the passages.
    int walls = (maze.rows() + 1) * maze.columns() + (maze.columns() + 1) * maze.rows() - 1;
    for (int row = 0; row < maze.rows(); ++row) {
      for (int column = 0; column < maze.columns(); ++column) {
        walls -= static_cast<int>(maze.isOpen({row, column}, Direction::kEast)) +
                 static_cast<int>(maze.isOpen({row, column}, Direction::kSouth));
      }
    }
    const double thickness = maze.wallThickness;
    const double clear = maze.cellSize - thickness;
    const double plan = (maze.rows() + 1) * (maze.columns() + 1) * thickness * thickness + walls * thickness * clear;
    const double cell = maze.cellSize;
    const double slab = (maze.rows() * cell + thickness) * (maze.columns() * cell + thickness);
    const double volume = plan * maze.wallHeight + slab * thickness;
    EXPECT_NEAR(signedVolume(structure), volume, volume * 1e-5) << seed;  // float coordinates of up to 30 m
  }
}

TEST(MazeMesh, IsWhereTheMazeSaysItIs) {
  Random random(1);
  size_t inWalls = 0;
  for (uint64_t seed = 10; seed < 14; ++seed) {
    const Maze maze = generateMaze(test::mazeOptions(seed));
    const Mesh structure = makeMazeScene(maze).meshes.at(0);
    const Box box = boundsOf(structure);
    for (int i = 0; i < 200; ++i) {
      glm::vec3 point(0, random.inRange(0.1f, maze.wallHeight - 0.1f), 0);
      point.x = random.inRange(box.lower.x - 1, box.upper.x + 1);
      point.z = random.inRange(box.lower.z - 1, box.upper.z + 1);
      const bool inside = windingNumber(structure, point) > 0.5;
      EXPECT_EQ(maze.isInWall(point), inside) << seed << ": " << point.x << " " << point.z;
      inWalls += inside ? 1 : 0;
    }
  }
  EXPECT_GT(inWalls, 50u);
}

TEST(MazeMesh, GivesEachLandmarkItsIdentityAndPlace) {
  const Maze maze = generateMaze({.seed = 4, .landmarks = 12});
  const Scene scene = makeMazeScene(maze);
  const Mesh mesh = flatten(scene);
  const std::vector<uint32_t> objects = objectOfTriangles(scene);
  ASSERT_EQ(objects.size(), mesh.triangles.size());
  std::vector<Box> boxes(13);
  for (size_t i = 0; i < objects.size(); ++i) {
    for (glm::length_t corner = 0; corner < 3; ++corner) {
      boxes.at(objects[i]).add(mesh.positions[mesh.triangles[i][corner]]);
    }
  }
  for (size_t i = 0; i < 12; ++i) {
    const Box& box = boxes[i + 1];
    const Box cell = maze.clearBox(maze.landmarks[i].cell);
    ASSERT_FALSE(box.empty());
    // Coordinates of up to 21 m as floats: 2e-6.
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(box.lower, cell.lower - 1e-5f))) << i;
    EXPECT_TRUE(glm::all(glm::lessThanEqual(box.upper, cell.upper + 1e-5f))) << i;
    EXPECT_NEAR(box.lower.y, 0.0f, 1e-5f) << "it stands on the floor";
  }
}

TEST(MazeMesh, LandmarksAreClosedWithTheirVolumes) {
  Maze maze(1, 3);
  maze.setOpen({0, 0}, Direction::kEast, true);
  maze.setOpen({0, 1}, Direction::kEast, true);
  for (const LandmarkShape shape : kLandmarkShapes) {
    const Mesh mesh = makeLandmark(maze, {{0, 1}, shape});
    EXPECT_TRUE(isClosed(mesh)) << nameOf(shape);
    EXPECT_GT(signedVolume(mesh), 0.0) << nameOf(shape);
    const Box box = boundsOf(mesh);
    if (shape == LandmarkShape::kArch) {
      EXPECT_NEAR(box.size().z, 0.98f * 2.7f, 1e-5f) << "it spans a passage to the east";
      continue;
    }
    for (const glm::vec3& position : mesh.positions) {
      EXPECT_LE(std::hypot(position.x - 4.5f, position.z - 1.5f), kLandmarkRadius * 3 + 1e-5f) << nameOf(shape);
    }
  }
  const double r = kLandmarkRadius * 3;
  const double cube = std::pow(std::sqrt(2.0) * r, 3);
  EXPECT_NEAR(signedVolume(makeLandmark(maze, {{0, 1}, LandmarkShape::kCube})), cube, cube * 1e-5);
  const double pyramid = 2 * r * r * 1.8 * r / 3;
  EXPECT_NEAR(signedVolume(makeLandmark(maze, {{0, 1}, LandmarkShape::kPyramid})), pyramid, pyramid * 1e-5);
}

TEST(BuiltinMaze, ComesWithItsGuidesInTheWorld) {
  const GuidedScene fitted = loadGuidedScene("builtin:maze,seed=4,rows=3,columns=5");
  const GuidedScene plain = loadGuidedScene("builtin:maze,seed=4,rows=3,columns=5", {.fit = false});
  ASSERT_TRUE(fitted.guides.maze && plain.guides.maze);
  EXPECT_EQ(*plain.guides.maze, generateMaze({.seed = 4, .rows = 3, .columns = 5}));
  EXPECT_EQ(plain.worldFromScene, glm::mat4(1));
  EXPECT_EQ(fitted.objectOfTriangle, plain.objectOfTriangle);
  ASSERT_EQ(fitted.objectOfTriangle.size(), fitted.mesh.triangles.size());
  for (size_t i = 0; i < fitted.mesh.triangles.size(); i += 97) {
    const glm::vec3& small = fitted.mesh.positions[fitted.mesh.triangles[i].x];
    const glm::vec3& large = plain.mesh.positions[plain.mesh.triangles[i].x];
    EXPECT_LT(glm::distance(small, glm::vec3(fitted.worldFromScene * glm::vec4(large, 1))), 1e-6f);
  }
  // The walls of the moved maze are those of the fitted mesh.
  const Box box = boundsOf(fitted.mesh);
  const Maze& maze = *fitted.guides.maze;
  EXPECT_NEAR(maze.clearBox({0, 0}).lower.x - maze.wallThickness, box.lower.x, 1e-6f);
  EXPECT_NEAR(maze.clearBox({2, 4}).upper.z + maze.wallThickness, box.upper.z, 1e-6f);
  EXPECT_NEAR(maze.clearBox({0, 0}).upper.y, box.upper.y, 1e-6f);
}

TEST(BuiltinMaze, ReadsAFile) {
  const test::TemporaryFolder folder;
  const Maze maze = generateMaze({.seed = 9, .rows = 4, .columns = 3});
  const std::string path = (folder.path() / "maze.json").string();
  writeFile(path, jsonText(maze));
  EXPECT_EQ(loadGuidedScene("builtin:maze,file=" + path, {.fit = false}).guides.maze, maze);
  EXPECT_THROW(makeBuiltinScene("builtin:maze,seed=1,file=" + path), InputError);
  EXPECT_THROW(makeBuiltinScene("builtin:maze,file=none.json"), InputError);
  EXPECT_THROW(makeBuiltinScene("builtin:maze,file="), InputError);
}

}  // namespace
}  // namespace ocelli
