#include "oc_core/scene/mesh_series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Mesh triangleAt(float x, float color = 1) {
  Mesh mesh;
  mesh.positions = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}};
  mesh.colors.assign(3, glm::vec3(color));
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// The same triangle by other corners first.
Mesh otherTriangles() {
  Mesh mesh = triangleAt(7);
  mesh.triangles = {{1, 2, 0}};
  return mesh;
}

float xAt(const MovingScene& scene, double seconds) {
  MovedMesh moved;
  scene.moveTo(seconds, moved);
  return moved.mesh.positions[0].x;
}

TEST(NumberedFiles, AreOrderedByTheirNumbers) {
  const test::TemporaryFolder folder;
  for (const char* name : {"walk_10.ply", "walk_9.ply", "walk_007.ply", "readme.txt", "other.ply", "x11.obj"}) {
    folder.write(name, "");
  }
  std::vector<std::string> names;
  for (const auto& file : numberedFiles(folder.path(), ".ply")) {
    names.push_back(file.filename().string());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"walk_007.ply", "walk_9.ply", "walk_10.ply"}));
  EXPECT_THAT([&] { meshEndingIn(folder.path()); }, ThrowsMessage<InputError>(HasSubstr(".obj and in .ply")));
  folder.write("run_9.ply", "");
  EXPECT_THROW(numberedFiles(folder.path(), ".ply"), InputError);
  EXPECT_THROW(numberedFiles(folder.path(), ".stl"), InputError);
  EXPECT_THROW(numberedFiles(folder / "none", ".ply"), InputError);
}

TEST(NumberedFiles, HaveTheOneEndingThatIsThere) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(meshEndingIn(folder.path()), InputError);
  EXPECT_THROW(meshEndingIn(folder / "none"), InputError);
  for (const char* name : {"walk_1.obj", "walk_2.obj", "walk_1.mtl", "notes_1.txt", "rest.ply"}) {
    folder.write(name, "");
  }
  EXPECT_EQ(meshEndingIn(folder.path()), ".obj");
}

TEST(MeshSeries, HoldsEachMeshUntilTheNextOne) {
  const MeshSeries series({triangleAt(0), triangleAt(1), triangleAt(2)}, {.meshesPerSecond = 10});
  EXPECT_DOUBLE_EQ(series.durationSeconds(), 0.3);
  EXPECT_EQ(series.sampleTimes().size(), 3u);
  EXPECT_EQ(series.facts().meshes, 3u);
  EXPECT_EQ(series.facts().topologies, 1u);
  for (const auto& [seconds, x] : std::vector<std::pair<double, float>>{
           {-1, 0}, {0, 0}, {0.099, 0}, {0.1, 1}, {0.199, 1}, {0.2, 2}, {0.3, 2}, {9, 2}}) {
    EXPECT_EQ(xAt(series, seconds), x) << seconds;
  }
  // The times of 3 in 10: quotients that round down.
  const MeshSeries odd(std::vector<Mesh>(10, triangleAt(0)), {.meshesPerSecond = 3});
  MovedMesh moved;
  for (size_t i = 0; i < 10; ++i) {
    odd.moveTo(odd.sampleTimes()[i], moved);
    EXPECT_EQ(moved.shape, std::bit_cast<uint64_t>(static_cast<double>(i)));
  }
}

TEST(MeshSeries, GoesStraightFromMeshToMeshWhereThatIsAsked) {
  const MeshSeries series({triangleAt(0, 0), triangleAt(4, 1), otherTriangles()},
                          {.meshesPerSecond = 2, .between = BetweenMeshes::kLinear});
  EXPECT_EQ(xAt(series, 0), 0);
  EXPECT_FLOAT_EQ(xAt(series, 0.125), 1);
  EXPECT_FLOAT_EQ(xAt(series, 0.375), 3);
  MovedMesh moved;
  series.moveTo(0.25, moved);
  EXPECT_FLOAT_EQ(moved.mesh.colors[0].x, 0.5f);
  // To other triangles there is no way between.
  EXPECT_EQ(xAt(series, 0.75), 4);
  EXPECT_EQ(xAt(series, 1), 7);
  EXPECT_EQ(xAt(series, 1.25), 7);
}

TEST(MeshSeries, TellsTopologiesApart) {
  Mesh plain = triangleAt(3);
  plain.colors.clear();
  const MeshSeries series({triangleAt(0), otherTriangles(), triangleAt(1), plain}, {.meshesPerSecond = 1});
  EXPECT_EQ(series.facts().topologies, 3u);
  MovedMesh moved;
  std::vector<uint64_t> seen;
  for (const double time : series.sampleTimes()) {
    series.moveTo(time, moved);
    seen.push_back(moved.topology);
  }
  EXPECT_EQ(seen[0], seen[2]);
  EXPECT_NE(seen[0], seen[1]);
  EXPECT_NE(seen[0], seen[3]);
  // Whatever was there before.
  MovedMesh fresh;
  series.moveTo(1, fresh);
  series.moveTo(1, moved);
  EXPECT_EQ(fresh.mesh.positions, moved.mesh.positions);
  EXPECT_EQ(fresh.mesh.triangles, moved.mesh.triangles);
}

TEST(MovingScene, IsFittedForAllOfItsMotion) {
  const MeshSeries series({triangleAt(0), triangleAt(9)}, {});
  const glm::mat4 unit = unitFromMotion(series, "here");
  // All x from 0 to 10 and y from 0 to 1: the farthest vertices from the middle are corners of that.
  const float radius = std::sqrt(25.0f + 0.25f);
  EXPECT_NEAR(unit[0][0], 1 / radius, 1e-6f);
  EXPECT_NEAR(unit[3].x, -5 / radius, 1e-6f);
  Mesh point;
  point.positions.assign(3, glm::vec3(1));
  point.triangles = {{0, 1, 2}};
  EXPECT_THROW(unitFromMotion(MeshSeries({point}, {}), "here"), InputError);
}

TEST(MovingScene, LoopsOrStaysAtItsEnd) {
  EXPECT_DOUBLE_EQ(timeInMotion(2.5, 2, true), 0.5);
  EXPECT_DOUBLE_EQ(timeInMotion(-0.5, 2, true), 1.5);
  EXPECT_DOUBLE_EQ(timeInMotion(2.5, 2, false), 2);
  EXPECT_DOUBLE_EQ(timeInMotion(-1, 2, false), 0);
  EXPECT_EQ(evenTimes(1, 3), (std::vector<double>{0, 0.5, 1}));
}

}  // namespace
}  // namespace ocelli
