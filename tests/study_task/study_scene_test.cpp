#include "study/task/study_scene.h"

#include <gtest/gtest.h>

#include <set>

#include "oc_core/base/json_fields.h"
#include "oc_core/worlds/maze_mesh.h"
#include "study/task/controls.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

Maze mazeWithTwo() {
  Maze maze = test::studyMaze();
  maze.landmarks = {{{2, 3}, LandmarkShape::kSphere, LandmarkColor::kOrange},
                    {{0, 0}, LandmarkShape::kCube, LandmarkColor::kBlue}};
  return maze;
}

TEST(StudyScene, onlyObjectsHaveColours) {
  const StudyScene scene(mazeWithTwo());
  const Mesh& mesh = scene.mesh();
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::vec3 color = mesh.color(mesh.triangles[i].x);
    const float range = std::max({color.x, color.y, color.z}) - std::min({color.x, color.y, color.z});
    if (scene.objectOfTriangle()[i] == 0) {
      EXPECT_EQ(range, 0);
    } else {
      EXPECT_GT(range, 0.05f);
    }
  }
}

TEST(StudyScene, wallsOfTheTwoAxesDiffer) {
  const Scene scene = makeMazeScene(test::studyMaze(), {.plain = true});
  const Mesh& mesh = scene.meshes[0];
  float darkestNorth = 1;
  float lightestEast = 0;
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::vec3 a = mesh.positions[triangle.x];
    const glm::vec3 normal = glm::cross(mesh.positions[triangle.y] - a, mesh.positions[triangle.z] - a);
    const float middle = (a.y + mesh.positions[triangle.y].y + mesh.positions[triangle.z].y) / 3;
    if (middle < 0.4f || std::abs(normal.y) > 1e-6f) {
      continue;  // the floor, tops, and what is dark at the foot of walls
    }
    const float grey = mesh.color(triangle.x).x;
    (std::abs(normal.z) > std::abs(normal.x) ? darkestNorth : lightestEast) =
        std::abs(normal.z) > std::abs(normal.x) ? std::min(darkestNorth, grey) : std::max(lightestEast, grey);
  }
  EXPECT_GT(darkestNorth, lightestEast);
}

TEST(StudyScene, theEntranceIsClosedUnlessOneLooksIn) {
  // The middle of the opening of the entrance.
  const auto isClosed = [](const StudyScene& scene) {
    for (const glm::uvec3& triangle : scene.mesh().triangles) {
      const glm::vec3 middle = (scene.mesh().positions[triangle.x] + scene.mesh().positions[triangle.y] +
                                scene.mesh().positions[triangle.z]) /
                               3.0f;
      if (std::abs(middle.x - 10.5f) < 1 && std::abs(middle.z - 14.85f) < 0.01f && middle.y > 0.5f) {
        return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(isClosed(StudyScene(test::studyMaze())));
  EXPECT_FALSE(isClosed(StudyScene(test::studyMaze(), false)));
}

TEST(StudyScene, objectsMoveByThemselves) {
  const StudyScene scene(mazeWithTwo());
  Mesh mesh = scene.mesh();
  const std::vector<glm::vec3> offsets{{1, 0, 0}};
  scene.moveObjects(mesh, offsets);
  const VertexRange first = scene.verticesOf(0);
  ASSERT_GT(first.count, 10u);
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const bool moves = i >= first.first && i < first.first + first.count;
    EXPECT_EQ(mesh.positions[i], scene.mesh().positions[i] + (moves ? offsets[0] : glm::vec3(0)));
  }
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const uint32_t object = scene.objectOfTriangle()[i];
    const uint32_t vertex = mesh.triangles[i].x;
    const bool isFirst = vertex >= first.first && vertex < first.first + first.count;
    EXPECT_EQ(object == 1, isFirst);
  }
  EXPECT_NEAR((scene.boxOf(0).lower.x + scene.boxOf(0).upper.x) / 2, 10.5f, 1e-4f);
}

Controls controlsOf(const std::string& text) {
  const nlohmann::json json = parseJson(text, "controls");
  JsonFields fields(json, "controls");
  return readControls(fields);
}

TEST(Controls, areRead) {
  const Controls controls = controlsOf(R"({"forward": "I", "select": "F", "walk_meters_per_second": 2})");
  EXPECT_EQ(controls.forward, Key::kI);
  EXPECT_EQ(controls.select, Key::kF);
  EXPECT_EQ(controls.backward, Key::kS);
  EXPECT_EQ(controls.walkMetersPerSecond, 2);
}

TEST(Controls, sayWhatIsWrong) {
  const auto expect = [](const std::string& text, const std::string& part) {
    try {
      controlsOf(text);
      ADD_FAILURE() << text;
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  expect(R"({"forward": "Up"})", "arrows");
  expect(R"({"forward": "F10"})", "F keys");
  expect(R"({"forward": "5"})", "digits");
  expect(R"({"forward": "Q"})", "same key");
  expect(R"({"forward": "Shift"})", "no key");
  expect(R"({"walk_meters_per_second": 0})", "walk_meters_per_second");
  expect(R"({"forwards": "W"})", "forwards");
}

}  // namespace
}  // namespace ocelli
