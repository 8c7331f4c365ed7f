#include "oc_core/worlds/scene_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/scene.h"
#include "oc_core/worlds/solids.h"
#include "oc_core/worlds/waving_scene.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Two boxes, the second of them turned and moved; numbered in a folder.
class SeriesFolder {
 public:
  SeriesFolder() {
    const Mesh box = makeBox(glm::vec3(1, 2, 1));
    Mesh turned = box;
    transform(turned, glm::rotate(glm::translate(glm::mat4(1), glm::vec3(3, 0, 0)), 0.7f, glm::vec3(0, 1, 0)));
    writePly(folder_ / "b_1.ply", box);
    writePly(folder_ / "b_2.ply", turned);
  }
  std::string path() const { return folder_.path().string(); }

 private:
  TemporaryFolder folder_;
};

TEST(WavingScene, PutsEachLayerOnItsCircle) {
  const Mesh box = makeBox(glm::vec3(1, 2, 1));
  const Box bounds = boundsOf(box);
  const WavingScene scene(box, 4, 0.5f);
  MovedMesh moved;
  for (const double seconds : {0.0, 1.0, 3.3}) {
    scene.moveTo(seconds, moved);
    for (size_t i = 0; i < box.positions.size(); ++i) {
      const double height = static_cast<double>((box.positions[i].y - bounds.lower.y) / bounds.size().y);
      const double angle = 2 * kPi * (seconds / 4 - height);
      const glm::vec3 expected = box.positions[i] + 0.5f * glm::vec3(std::cos(angle), 0, std::sin(angle));
      EXPECT_LT(glm::distance(moved.mesh.positions[i], expected), 1e-5f);  // rounding
    }
  }
  // After one round it is where it was.
  MovedMesh start;
  scene.moveTo(0, start);
  scene.moveTo(4, moved);
  for (size_t i = 0; i < box.positions.size(); ++i) {
    EXPECT_LT(glm::distance(moved.mesh.positions[i], start.mesh.positions[i]), 1e-5f);
  }
}

TEST(SceneMotion, IsTheMeshOfItsTimeFittedWithAllOthers) {
  const SeriesFolder series;
  SceneOptions options;
  options.motion.meshesPerSecond = 2;
  const auto motion = loadMotion(series.path(), options);
  ASSERT_NE(motion, nullptr);
  EXPECT_EQ(motion->durationSeconds(), 1);
  float reach = 0;
  for (const char* name : {"/b_1.ply", "/b_2.ply"}) {
    // Loaded by itself, fitted as the motion is, and shaded: but for the rounding of normals the same, as a box has the
    // same creases however it stands.
    Mesh expected = loadScene(series.path() + name, {.fit = false, .shading = Shading::kNone});
    transform(expected, motion->worldFromScene());
    const TemporaryFolder folder;
    writePly(folder / "fitted.ply", expected);
    expected = loadScene((folder / "fitted.ply").string(), {.fit = false});
    const Mesh& mesh = motion->at(name[3] == '1' ? 0 : 0.6);
    ASSERT_EQ(mesh.triangles, expected.triangles);
    ASSERT_EQ(mesh.positions, expected.positions);
    for (size_t i = 0; i < mesh.colors.size(); ++i) {
      EXPECT_LT(glm::distance(mesh.colors[i], expected.colors[i]), 1e-5f);
      reach = std::max(reach, glm::length(mesh.positions[i]));
    }
  }
  EXPECT_NEAR(reach, 1, 1e-5f);
}

TEST(SceneMotion, IsTheSameWhateverWasAskedBefore) {
  const std::string source = "builtin:waving,seconds=2";
  const auto motion = loadMotion(source, {});
  for (const double time : {1.9, 0.0, 0.7}) {
    motion->at(time);
  }
  setThreadCount(1);
  const auto again = loadMotion(source, {});
  EXPECT_EQ(again->at(0.7).positions, motion->at(0.7).positions);
  EXPECT_EQ(again->at(0.7).colors, motion->at(0.7).colors);
  setThreadCount(0);
  EXPECT_EQ(again->topology(), motion->topology());
  const uint64_t shape = motion->shape();
  motion->at(0.8);
  EXPECT_NE(motion->shape(), shape);
}

TEST(SceneMotion, KeepsTheTrianglesAndMovesThemAll) {
  const auto motion = loadMotion("builtin:waving,triangles=5000", {});
  const Mesh before = motion->at(0.3);
  const Mesh& after = motion->at(0.35);
  EXPECT_EQ(before.triangles, after.triangles);
  for (size_t i = 0; i < before.positions.size(); ++i) {
    ASSERT_NE(before.positions[i], after.positions[i]);
  }
}

TEST(LoadScene, TakesOneMomentOfWhatMoves) {
  const SeriesFolder series;
  SceneOptions options;
  options.motion.seconds = 1.0 / 24;
  const auto motion = loadMotion(series.path(), options);
  EXPECT_EQ(loadScene(series.path(), options).positions, motion->at(1.0 / 24).positions);
  EXPECT_NE(loadScene(series.path(), options).positions, motion->at(0).positions);
  // At rest a scene that may move is a still one.
  EXPECT_EQ(loadScene("builtin:waving").positions.size(), loadMotion("builtin:waving", {})->at(0).positions.size());
}

TEST(SceneMotion, PlaysPointsWhoseNumberChanges) {
  const TemporaryFolder folder;
  const auto writePoints = [&](const std::string& name, int side) {
    std::string text;
    for (int i = 0; i < side * side; ++i) {
      text += std::to_string(i % side) + " " + std::to_string(i / side) + " 0\n";
    }
    folder.write(name, text);
  };
  writePoints("cloud_1.xyz", 10);
  writePoints("cloud_2.xyz", 20);
  SceneOptions options;
  options.motion.meshesPerSecond = 1;
  const auto motion = loadMotion(folder.path().string(), options);
  ASSERT_NE(motion, nullptr);
  EXPECT_EQ(motion->durationSeconds(), 2);
  EXPECT_EQ(motion->at(0).triangles.size(), 200u);
  EXPECT_EQ(motion->at(1).triangles.size(), 800u);
  options.motion.seconds = 1;
  options.points.width = 0.1;
  EXPECT_EQ(loadScene(folder.path().string(), options).triangles.size(), 800u);
}

TEST(LoadScene, RefusesMomentsThatAreNotThere) {
  const SeriesFolder series;
  const auto refusal = [](const std::string& source, const MotionOptions& motion, const std::string& why) {
    SceneOptions options;
    options.motion = motion;
    EXPECT_THAT([&] { loadScene(source, options); }, ThrowsMessage<InputError>(HasSubstr(why)));
  };
  refusal("builtin:teapot", {.seconds = 0}, "does not move");
  refusal("builtin:waving", {.seconds = 4.1}, "from 0 to 4");
  refusal("builtin:waving", {.seconds = -1}, "from 0 to 4");
  refusal("builtin:waving", {.seconds = 1, .meshesPerSecond = 5}, "only a folder");
  refusal("builtin:waving", {.animation = "walk"}, "give --time");
  refusal("builtin:waving", {.seconds = 1, .animation = "walk"}, "only a file");
  refusal(series.path(), {}, "--time 0");
  refusal("builtin:waving,sway=11", {.seconds = 0}, "sway");
}

}  // namespace
}  // namespace ocelli
