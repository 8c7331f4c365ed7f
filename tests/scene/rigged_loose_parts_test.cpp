// Lines and points of files whose animation plays.
#include "oc_core/scene/rigged_loose_parts.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/animated_gltf.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

using test::AnimatedGltf;
using test::TemporaryFolder;

constexpr float kEighthTurn = 0.70710678f;  // sine and cosine of 45 degrees
constexpr int kPointsMode = 0;
constexpr int kLineStripMode = 3;

class LooseAnimation {
 public:
  explicit LooseAnimation(const std::string& text, double width = 0.25) {
    const std::filesystem::path path = folder_.write("a.gltf", text);
    const SceneFileOptions options{.points = {.width = width}};
    scene = readAnimatedFile(path, options, "", warnings);
    atRest = flatten(readSceneFile(path, options));
  }

  Mesh at(double seconds) const {
    MovedMesh moved;
    scene->moveTo(seconds, moved);
    return moved.mesh;
  }

  std::unique_ptr<MovingScene> scene;
  std::vector<std::string> warnings;
  Mesh atRest;

 private:
  TemporaryFolder folder_;
};

void expectAlike(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_LT(glm::distance(a[i], b[i]), 1e-5f) << i;  // some roundings of single precision
  }
}

/// Four corners of a bent line as a primitive of that mode, at a node that stands as `node` says and turns by a quarter
/// about z within a second, and its parent, which is moved by (1, 2, 3).
std::string turningLine(int mode, const std::string& node = R"("scale": [2, 2, 2])") {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 2, 0.5f, 0, 2, 1, 1});
  const int times = file.floats("SCALAR", {0, 1});
  const int keys = file.floats("VEC4", {0, 0, 0, 1, 0, 0, kEighthTurn, kEighthTurn});
  return file.text(fmt::format(
      R"("scenes": [{{"nodes": [0]}}],
         "nodes": [{{"name": "up", "translation": [1, 2, 3], "children": [1]}}, {{"name": "arm", "mesh": 0, {}}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}, "mode": {}}}]}}],
         "animations": [{{"samplers": [{{"input": {}, "output": {}}}],
                          "channels": [{{"sampler": 0, "target": {{"node": 1, "path": "rotation"}}}}]}}])",
      node, corners, mode, times, keys));
}

// What stands at a node is what it is at rest, turned with the node.
TEST(RiggedLooseParts, TurnWithTheirNode) {
  for (const int mode : {kLineStripMode, kPointsMode}) {
    const LooseAnimation played(turningLine(mode));
    ASSERT_NE(played.scene, nullptr);
    EXPECT_TRUE(played.warnings.empty());
    ASSERT_TRUE(played.scene->facts().points);
    EXPECT_EQ(played.scene->facts().points->lines, mode == kLineStripMode ? 3u : 0u);
    EXPECT_EQ(played.scene->facts().points->points, mode == kPointsMode ? 4u : 0u);
    expectAlike(played.at(0).positions, played.atRest.positions);
    EXPECT_EQ(played.at(0).triangles, played.atRest.triangles);
    for (const double seconds : {0.25, 1.0}) {
      const glm::mat4 up = glm::translate(glm::mat4(1), glm::vec3(1, 2, 3));
      const glm::mat4 turn =
          up * glm::rotate(glm::mat4(1), static_cast<float>(seconds * kPi / 2), glm::vec3(0, 0, 1)) * glm::inverse(up);
      std::vector<glm::vec3> turned;
      for (const glm::vec3& p : played.atRest.positions) {
        turned.emplace_back(turn * glm::vec4(p, 1));
      }
      expectAlike(played.at(seconds).positions, turned);
    }
  }
}

TEST(RiggedLooseParts, AreNotInsideOutAtMirroredNodes) {
  for (const char* node : {R"("scale": [2, 2, 2])", R"("scale": [-2, 2, 2])"}) {
    const LooseAnimation played(turningLine(kLineStripMode, node));
    EXPECT_GT(signedVolume(played.at(0)), 0.1) << node;
    EXPECT_NEAR(signedVolume(played.at(1)), signedVolume(played.at(0)), 1e-4) << node;
  }
}

// Whatever the node is at rest, what it is as it plays is a place.
TEST(RiggedLooseParts, StandSomewhereWhereTheNodeHasNoSize) {
  const LooseAnimation played(turningLine(kLineStripMode, R"("scale": [1, 0, 0])"));
  for (const glm::vec3& p : played.at(0.5).positions) {
    EXPECT_TRUE(isFinite(p));
  }
}

/// A line of three corners, of which the upper bone bends the last one by a right angle about (0, 1, 0), and a morph
/// target moves the first one along x.
std::string bendingLine() {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 0, 0, 1, 0, 0, 2, 0});
  const int aside = file.floats("VEC3", {1, 0, 0, 0, 0, 0, 0, 0, 0});
  const int joints = file.shorts("VEC4", {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
  const int weights = file.floats("VEC4", {1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0, 1, 0, 0});
  const int inverse = file.floats(
      "MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  const int times = file.floats("SCALAR", {0, 1});
  const int keys = file.floats("VEC4", {0, 0, 0, 1, 0, 0, kEighthTurn, kEighthTurn});
  const int shares = file.floats("SCALAR", {0, 0.5f});
  return file.text(fmt::format(
      R"("scenes": [{{"nodes": [0, 2]}}],
         "nodes": [{{"name": "lower", "children": [1]}}, {{"name": "upper", "translation": [0, 1, 0]}},
                   {{"name": "body", "mesh": 0, "skin": 0, "translation": [50, 0, 0]}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}, "JOINTS_0": {}, "WEIGHTS_0": {}}}, "mode": 3,
                                      "targets": [{{"POSITION": {}}}]}}], "weights": [0]}}],
         "skins": [{{"joints": [0, 1], "inverseBindMatrices": {}}}],
         "animations": [{{"samplers": [{{"input": {}, "output": {}}}, {{"input": {}, "output": {}}}],
                          "channels": [{{"sampler": 0, "target": {{"node": 1, "path": "rotation"}}}},
                                       {{"sampler": 1, "target": {{"node": 2, "path": "weights"}}}}]}}])",
      corners, joints, weights, aside, inverse, times, keys, times, shares));
}

// The tube has an end, three rings and an end. Each ring stays around its corner, across the bone that moves it.
TEST(RiggedLooseParts, BendWithTheirBones) {
  constexpr float kRadius = 0.125f;
  const LooseAnimation played(bendingLine(), 2 * static_cast<double>(kRadius));
  ASSERT_NE(played.scene, nullptr);
  EXPECT_TRUE(played.warnings.empty());
  const std::vector<glm::vec3> straight = played.at(0).positions;
  const std::vector<glm::vec3> bent = played.at(1).positions;
  constexpr size_t kSides = 8;
  ASSERT_EQ(bent.size(), 3 * kSides + 2);
  const auto middleOf = [](const std::vector<glm::vec3>& positions, size_t ring) {
    glm::vec3 sum(0);
    for (size_t i = 0; i < kSides; ++i) {
      sum += positions[1 + ring * kSides + i] / static_cast<float>(kSides);
    }
    return sum;
  };
  EXPECT_LT(glm::distance(middleOf(straight, 2), {0, 2, 0}), 1e-5f);
  EXPECT_LT(glm::distance(middleOf(bent, 0), {0.5f, 0, 0}), 1e-5f) << "by the morph target";
  EXPECT_LT(glm::distance(middleOf(bent, 1), {0, 1, 0}), 1e-5f);
  EXPECT_LT(glm::distance(middleOf(bent, 2), {-1, 1, 0}), 1e-5f) << "by the upper bone";
  for (size_t i = 0; i < kSides; ++i) {
    const glm::vec3 offset = bent[1 + 2 * kSides + i] - glm::vec3(-1, 1, 0);
    EXPECT_NEAR(glm::length(offset), kRadius, 1e-5f);
    EXPECT_NEAR(offset.x, 0, 1e-5f) << "the tube runs along x there";
  }
}

TEST(RiggedLooseParts, KeepTheColorsOfTheirVertices) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 0, 1, 0, 0});
  const int colors = file.floats("VEC3", {1, 0, 0, 0, 0, 1});
  const int times = file.floats("SCALAR", {0, 1});
  const int keys = file.floats("VEC3", {0, 0, 0, 0, 0, 5});
  const LooseAnimation played(file.text(fmt::format(
      R"("scenes": [{{"nodes": [0]}}], "nodes": [{{"name": "arm", "mesh": 0}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}, "COLOR_0": {}}}, "mode": 3}}]}}],
         "animations": [{{"samplers": [{{"input": {}, "output": {}}}],
                          "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "translation"}}}}]}}])",
      corners, colors, times, keys)));
  const Mesh mesh = played.at(1);
  for (uint32_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_EQ(mesh.color(i), mesh.positions[i].x < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1));
    EXPECT_GT(mesh.positions[i].z, 4.8f);
  }
}

}  // namespace
}  // namespace ocelli
