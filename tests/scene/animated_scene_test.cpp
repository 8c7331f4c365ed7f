#include "oc_core/scene/animated_scene.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/base/parallel.h"
#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/animated_gltf.h"

namespace ocelli {
namespace {

using test::AnimatedGltf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr float kQuarter = 0.70710678f;
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

struct ReadMotion {
  std::unique_ptr<MovingScene> scene;
  std::vector<std::string> warnings;
};

ReadMotion readText(const std::string& text, const std::string& animation = "") {
  const test::TemporaryFolder folder;
  ReadMotion read;
  read.scene = readAnimatedFile(folder.write("a.gltf", text), {}, animation, read.warnings);
  return read;
}

std::vector<glm::vec3> positionsAt(const MovingScene& scene, double seconds) {
  MovedMesh moved;
  scene.moveTo(seconds, moved);
  return moved.mesh.positions;
}

void expectPlayedAt(const glm::vec3& a, const glm::vec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-5f) << a.x << " " << a.y << " " << a.z;  // some roundings of single precision
}

/// A triangle at a node that turns by a quarter about z within two seconds, and its parent, which moves up by 3 in the
/// second of them. The second animation scales the parent; the third one has no key.
std::string turningTriangle(const std::string& interpolation = "LINEAR", const std::vector<float>& times = {0, 2},
                            std::vector<float> turns = {0, 0, 0, 1, 0, 0, kQuarter, kQuarter}) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {1, 0, 0, 2, 0, 0, 1, 1, 0});
  const int turnTimes = file.floats("SCALAR", times);
  const int turnKeys = file.floats("VEC4", turns);
  const int upTimes = file.floats("SCALAR", {1, 2});
  const int upKeys = file.floats("VEC3", {0, 0, 0, 0, 3, 0});
  const int scaleTimes = file.floats("SCALAR", {0, 4});
  const int scaleKeys = file.floats("VEC3", {1, 1, 1, 3, 3, 3});
  return file.text(fmt::format(
      R"("scenes": [{{"nodes": [0]}}],
         "nodes": [{{"name": "lift", "children": [1]}}, {{"name": "arm", "mesh": 0}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}}}]}}],
         "animations": [
           {{"name": "turn", "samplers": [{{"input": {}, "output": {}, "interpolation": "{}"}},
                                          {{"input": {}, "output": {}}}],
             "channels": [{{"sampler": 0, "target": {{"node": 1, "path": "rotation"}}}},
                          {{"sampler": 1, "target": {{"node": 0, "path": "translation"}}}}]}},
           {{"name": "grow", "samplers": [{{"input": {}, "output": {}}}],
             "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "scale"}}}}]}}])",
      corners, turnTimes, turnKeys, interpolation, upTimes, upKeys, scaleTimes, scaleKeys));
}

TEST(AnimatedFile, TurnsAndLiftsByItsNodes) {
  const ReadMotion read = readText(turningTriangle());
  ASSERT_NE(read.scene, nullptr);
  EXPECT_TRUE(read.warnings.empty());
  EXPECT_DOUBLE_EQ(read.scene->durationSeconds(), 2);
  const MotionFacts facts = read.scene->facts();
  ASSERT_EQ(facts.animations.size(), 2u);
  EXPECT_EQ(facts.animations[0].name, "turn");
  EXPECT_EQ(facts.animations[1].seconds, 4);
  EXPECT_EQ(facts.played, 0u);
  expectPlayedAt(positionsAt(*read.scene, 0)[1], {2, 0, 0});
  expectPlayedAt(positionsAt(*read.scene, 1)[1], {2 * kQuarter, 2 * kQuarter, 0});  // half of the angle, not lifted yet
  expectPlayedAt(positionsAt(*read.scene, 2)[1], {0, 5, 0});
  expectPlayedAt(positionsAt(*read.scene, 7)[1], {0, 5, 0});
}

TEST(AnimatedFile, PlaysTheAnimationThatIsAskedFor) {
  for (const char* name : {"grow", "2"}) {
    const ReadMotion read = readText(turningTriangle(), name);
    EXPECT_DOUBLE_EQ(read.scene->durationSeconds(), 4);
    expectPlayedAt(positionsAt(*read.scene, 2)[1], {4, 0, 0});
  }
  for (const char* name : {"0", "3", "none", "1x"}) {
    EXPECT_THAT([&] { readText(turningTriangle(), name); },
                ThrowsMessage<InputError>(HasSubstr("1 \"turn\", 2 \"grow\"")));
  }
}

TEST(AnimatedFile, StepsWhereItSaysSo) {
  const ReadMotion read = readText(turningTriangle("STEP"));
  expectPlayedAt(positionsAt(*read.scene, 0.9)[1], {2, 0, 0});
  expectPlayedAt(positionsAt(*read.scene, 1.9)[1], {2, 2.7f, 0});
  expectPlayedAt(positionsAt(*read.scene, 2)[1], {0, 5, 0});
}

TEST(AnimatedFile, KeysThatCannotBeAreLeftOut) {
  // The key at 1 s is no number, the one after it goes back in time.
  const ReadMotion read = readText(turningTriangle(
      "LINEAR", {0, 1, 0.5f, 2}, {0, 0, 0, 1, kNoNumber, 0, 0, 1, 0, 0, 0, 1, 0, 0, kQuarter, kQuarter}));
  ASSERT_NE(read.scene, nullptr);
  for (const double time : read.scene->sampleTimes()) {
    for (const glm::vec3& p : positionsAt(*read.scene, time)) {
      EXPECT_TRUE(isFinite(p)) << time;
    }
  }
  expectPlayedAt(positionsAt(*read.scene, 2)[1], {0, 5, 0});
}

TEST(AnimatedFile, WithoutAnAnimationThatTakesTimeStandsStill) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {1, 0, 0, 2, 0, 0, 1, 1, 0});
  const std::string still = fmt::format(
      R"("scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}}}]}}])",
      corners);
  EXPECT_EQ(readText(file.text(still)).scene, nullptr);
  const int time = file.floats("SCALAR", {0});
  const int place = file.floats("VEC3", {0, 0, 5});
  EXPECT_EQ(readText(file.text(still + fmt::format(R"(, "animations": [{{"samplers": [{{"input": {}, "output": {}}}],
      "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "translation"}}}}]}}])",
                                                   time, place)))
                .scene,
            nullptr);
}

// A file that moves is at rest what it was before it could be played.
TEST(AnimatedFile, IsAsItWasWhereItIsReadAsAStillScene) {
  const test::TemporaryFolder folder;
  const Scene scene = readSceneFile(folder.write("a.gltf", turningTriangle()));
  const Mesh mesh = flatten(scene);
  EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}));
  EXPECT_TRUE(scene.warnings.empty());
}

struct Arm {
  std::vector<float> weights{1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0, 1, 0, 0};
  std::vector<uint16_t> joints{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
};

/// A triangle whose three corners stand at (0, 2, 0): two bones, the upper one at (0, 1, 0), which bends by a right
/// angle about z within a second. The node of the mesh is moved aside, which counts for nothing, as it has a skin.
std::string bendingArm(const Arm& arm) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 2, 0, 0, 2, 0, 0, 2, 0});
  const int joints = file.shorts("VEC4", arm.joints);
  const int weights = file.floats("VEC4", arm.weights);
  // Mesh to bone when it was bound: the lower one stands at the origin, the upper one 1 above it.
  const int inverse = file.floats(
      "MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  const int times = file.floats("SCALAR", {0, 1});
  const int keys = file.floats("VEC4", {0, 0, 0, 1, 0, 0, kQuarter, kQuarter});
  return file.text(fmt::format(
      R"("scenes": [{{"nodes": [0, 2]}}],
         "nodes": [{{"name": "lower", "children": [1]}}, {{"name": "upper", "translation": [0, 1, 0]}},
                   {{"name": "body", "mesh": 0, "skin": 0, "translation": [50, 0, 0]}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}, "JOINTS_0": {}, "WEIGHTS_0": {}}}}}]}}],
         "skins": [{{"joints": [0, 1], "inverseBindMatrices": {}}}],
         "animations": [{{"samplers": [{{"input": {}, "output": {}}}],
                          "channels": [{{"sampler": 0, "target": {{"node": 1, "path": "rotation"}}}}]}}])",
      corners, joints, weights, inverse, times, keys));
}

TEST(AnimatedFile, BendsWithItsBones) {
  const ReadMotion read = readText(bendingArm({}));
  ASSERT_NE(read.scene, nullptr);
  for (const glm::vec3& p : positionsAt(*read.scene, 0)) {
    expectPlayedAt(p, {0, 2, 0});
  }
  const std::vector<glm::vec3> bent = positionsAt(*read.scene, 1);
  expectPlayedAt(bent[0], {0, 2, 0});         // the lower bone's alone
  expectPlayedAt(bent[2], {-1, 1, 0});        // the upper one's
  expectPlayedAt(bent[1], {-0.5f, 1.5f, 0});  // half and half: the middle of both
  const std::vector<glm::vec3> half = positionsAt(*read.scene, 0.5);
  expectPlayedAt(half[2], {-kQuarter, 1 + kQuarter, 0});
}

TEST(AnimatedFile, WeightsThatDoNotAddUpToOneAreScaled) {
  const ReadMotion read = readText(bendingArm({.weights = {4, 0, 0, 0, 2, 2, 0, 0, 0, 0.25f, 0, 0}}));
  const std::vector<glm::vec3> bent = positionsAt(*read.scene, 1);
  expectPlayedAt(bent[0], {0, 2, 0});
  expectPlayedAt(bent[1], {-0.5f, 1.5f, 0});
  expectPlayedAt(bent[2], {-1, 1, 0});
}

TEST(AnimatedFile, WeightsThatAreNoNumbersCountForNothing) {
  const ReadMotion read = readText(bendingArm({.weights = {kNoNumber, 0, 0, 0, kNoNumber, 3, 0, 0, -5, 1, 0, 0}}));
  const std::vector<glm::vec3> bent = positionsAt(*read.scene, 1);
  expectPlayedAt(bent[0], {50, 2, 0});  // by no bone: by its node
  expectPlayedAt(bent[1], {-1, 1, 0});
  expectPlayedAt(bent[2], {-1, 1, 0});
}

// Joints, samplers, accessors and nodes that are not there: an error that names the file, or what is left of it.
TEST(AnimatedFile, SurvivesIndicesOutOfRange) {
  const std::string good = bendingArm({});
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  for (const std::string& text :
       {bendingArm({.joints = {0, 1, 0, 0, 0, 1, 0, 0, 0, 60000, 0, 0}}),
        changed(R"("joints": [0, 1])", R"("joints": [0, 99])"), changed(R"("sampler": 0)", R"("sampler": 7)"),
        changed(R"("node": 1)", R"("node": 99)"), changed(R"("joints": [0, 1])", R"("joints": [])"),
        changed(R"("children": [1])", R"("children": [1, 44])"), changed(R"("skin": 0)", R"("skin": 3)"),
        changed(R"("path": "rotation")", R"("path": "colour")")}) {
    try {
      const ReadMotion read = readText(text);
      for (const double time : read.scene == nullptr ? std::vector<double>{} : read.scene->sampleTimes()) {
        for (const glm::vec3& p : positionsAt(*read.scene, time)) {
          EXPECT_TRUE(isFinite(p));
        }
      }
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("a.gltf"));
    }
  }
}

TEST(AnimatedFile, MorphsAsItsWeightsSay) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int wide = file.floats("VEC3", {0, 0, 0, 2, 0, 0, 0, 0, 0});
  const int deep = file.floats("VEC3", {0, 0, 0, 0, 0, 4, 0, 0, 0});
  const int times = file.floats("SCALAR", {0, 1});
  const int weights = file.floats("SCALAR", {0, 0, 1, 0.5f});
  const ReadMotion read = readText(file.text(fmt::format(
      R"("scenes": [{{"nodes": [0]}}], "nodes": [{{"name": "face", "mesh": 0}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}, "targets": [{{"POSITION": {}}}, {{"POSITION": {}}}]}}],
                      "weights": [0, 0]}}],
         "animations": [{{"samplers": [{{"input": {}, "output": {}}}],
                          "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "weights"}}}}]}}])",
      corners, wide, deep, times, weights)));
  ASSERT_NE(read.scene, nullptr);
  expectPlayedAt(positionsAt(*read.scene, 0)[1], {1, 0, 0});
  expectPlayedAt(positionsAt(*read.scene, 0.5)[1], {2, 0, 1});
  expectPlayedAt(positionsAt(*read.scene, 1)[1], {3, 0, 2});
}

TEST(AnimatedScene, IsTheSameWithAnyNumberOfThreads) {
  const ReadMotion read = readText(bendingArm({}));
  setThreadCount(1);
  const std::vector<glm::vec3> one = positionsAt(*read.scene, 0.3);
  setThreadCount(4);
  const std::vector<glm::vec3> four = positionsAt(*read.scene, 0.3);
  setThreadCount(0);
  EXPECT_EQ(one, four);
}

// Middles of edges that baking has split stay in the middle, also those of two middles; what no triangle uses is left
// out.
TEST(AnimatedScene, MovesSplitEdgesWithTheirEnds) {
  RiggedMesh mesh;
  mesh.mesh.positions = {{0, 0, 0}, {9, 9, 9}, {4, 0, 0}, {0, 4, 0}, {2, 0, 0}, {1, 0, 0}};
  mesh.mesh.triangles = {{0, 5, 3}, {5, 4, 3}, {4, 2, 3}};
  mesh.added = {{0, 2, 0.5f}, {0, 4, 0.5f}};
  Rig rig;
  rig.nodes.resize(2);
  rig.instanceNodes = {0};
  RigPart part;
  part.bones = {{0, glm::mat4(1)}, {1, glm::mat4(1)}};
  part.first = {0, 1, 2, 3, 4};
  part.weights = {{0, 1}, {0, 1}, {1, 1}, {0, 1}};
  rig.parts = {part};
  rig.animations = {{"", {{1, RigTarget::kPosition, false, 3, {0, 1}, {0, 0, 0, 0, 0, 8}}}}};
  const AnimatedScene scene({mesh}, {{0, glm::mat4(1)}}, rig, "", "here");
  const std::vector<glm::vec3> moved = positionsAt(scene, 1);
  EXPECT_EQ(moved, (std::vector<glm::vec3>{{0, 0, 0}, {4, 0, 8}, {0, 4, 0}, {2, 0, 4}, {1, 0, 2}}));
}

TEST(AnimatedScene, RefusesNumbersOutOfAllBounds) {
  RiggedMesh mesh;
  mesh.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.mesh.triangles = {{0, 1, 2}};
  Rig rig;
  rig.nodes = {{kNoRigParent, glm::mat4(1)}, {0, glm::mat4(1)}};
  rig.instanceNodes = {1};
  rig.parts.resize(1);
  const RigChannel huge{0, RigTarget::kScale, false, 3, {0, 1}, {1, 1, 1, 1e30f, 1e30f, 1e30f}};
  RigChannel more = huge;
  more.node = 1;
  rig.animations = {{"", {huge, more}}};
  const AnimatedScene scene({mesh}, {{0, glm::mat4(1)}}, rig, "", "here");
  EXPECT_EQ(positionsAt(scene, 0)[1], glm::vec3(1, 0, 0));
  EXPECT_THAT([&] { positionsAt(scene, 1); }, ThrowsMessage<InputError>(HasSubstr("1 s")));
}

}  // namespace
}  // namespace ocelli
