// Skins and morph targets of files that stand still.
#include "oc_core/scene/rest_pose.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/animated_gltf.h"

namespace ocelli {
namespace {

using test::AnimatedGltf;
using test::TemporaryFolder;

void expectPosed(const glm::vec3& a, const glm::vec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-5f) << a.x << " " << a.y << " " << a.z;  // some roundings of single precision
}

/// A triangle with its corners at heights 0, 1 and 2 whose upper half belongs to a bone at height 1, which stands
/// turned by a right angle about z. The node of the mesh counts for nothing.
std::string bentFile() {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 0, 0, 1, 0, 0, 2, 0});
  const int joints = file.shorts("VEC4", {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
  const int weights = file.floats("VEC4", {1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0, 1, 0, 0});
  const int inverse = file.floats(
      "MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  return file.text(fmt::format(
      R"("scenes": [{{"nodes": [0, 2]}}],
         "nodes": [{{"name": "lower", "children": [1]}},
                   {{"name": "upper", "translation": [0, 1, 0], "rotation": [0, 0, 0.70710678, 0.70710678]}},
                   {{"name": "body", "mesh": 0, "skin": 0, "translation": [50, 0, 0]}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}, "JOINTS_0": {}, "WEIGHTS_0": {}}}}}]}}],
         "skins": [{{"joints": [0, 1], "inverseBindMatrices": {}}}])",
      corners, joints, weights, inverse));
}

TEST(RestPose, BendsSkinsAsTheirBonesStand) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.write("a.gltf", bentFile());
  const Mesh mesh = flatten(readSceneFile(path));
  ASSERT_EQ(mesh.positions.size(), 3u);
  expectPosed(mesh.positions[0], {0, 0, 0});
  expectPosed(mesh.positions[1], {0, 1, 0});
  expectPosed(mesh.positions[2], {-1, 1, 0});
  std::vector<std::string> warnings;
  EXPECT_EQ(readAnimatedFile(path, {}, "", warnings), nullptr) << "it has nothing to play";
}

/// A triangle with two morph targets, of which the second one has a weight at rest, at a node that mirrors x.
TEST(RestPose, TakesOnMorphTargetsWithWeights) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int wide = file.floats("VEC3", {0, 0, 0, 4, 0, 0, 0, 0, 0});
  const int deep = file.floats("VEC3", {0, 0, 0, 0, 0, 4, 0, 0, 0});
  const TemporaryFolder folder;
  const Mesh mesh = flatten(readSceneFile(
      folder.write("a.gltf", file.text(fmt::format(
                                 R"("scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0, "scale": [-1, 1, 1]}}],
         "meshes": [{{"weights": [0, 0.5], "primitives": [{{"attributes": {{"POSITION": {}}},
                      "targets": [{{"POSITION": {}}}, {{"POSITION": {}}}]}}]}}])",
                                 corners, wide, deep)))));
  ASSERT_EQ(mesh.positions.size(), 3u);
  expectPosed(mesh.positions[mesh.triangles[0].x], {0, 0, 0});
  expectPosed(mesh.positions[mesh.triangles[0].y], {0, 1, 0});  // turned round, as it is mirrored
  expectPosed(mesh.positions[mesh.triangles[0].z], {-1, 0, 2});
}

TEST(RestPose, LeavesCopiesOfTheSameMeshApart) {
  SceneRecord record;
  TexturedMesh part;
  part.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  part.mesh.triangles = {{0, 1, 2}};
  record.parts = {part, part};
  glm::mat4 aside(1);
  aside[3] = {7, 0, 0, 1};
  record.instances = {{0, aside}, {1, aside}, {0, glm::mat4(1)}};
  Rig rig;
  glm::mat4 up(1);
  up[3] = {0, 5, 0, 1};
  rig.nodes = {{kNoRigParent, up}};
  rig.instanceNodes = {0, 0, 0};
  rig.parts.resize(2);
  rig.parts[0].bones = {{0, glm::mat4(1)}};
  rig.parts[0].first = {0, 1, 2, 2};  // the last vertex has no bone: it stays with its node
  rig.parts[0].weights = {{0, 1}, {0, 1}};
  record.rig = rig;
  poseAtRest(record);
  EXPECT_FALSE(record.rig.has_value());
  ASSERT_EQ(record.parts.size(), 4u);
  EXPECT_TRUE(record.parts[0].mesh.positions.empty()) << "no copy is left of it";
  EXPECT_EQ(record.instances[1].mesh, 1u);
  EXPECT_EQ(record.instances[1].worldFromMesh, aside);
  EXPECT_EQ(record.parts[record.instances[0].mesh].mesh.positions,
            (std::vector<glm::vec3>{{0, 5, 0}, {1, 5, 0}, {7, 1, 0}}));
  EXPECT_EQ(record.parts[record.instances[2].mesh].mesh.positions,
            (std::vector<glm::vec3>{{0, 5, 0}, {1, 5, 0}, {0, 1, 0}}));
  EXPECT_EQ(record.instances[0].worldFromMesh, glm::mat4(1));
}

}  // namespace
}  // namespace ocelli
