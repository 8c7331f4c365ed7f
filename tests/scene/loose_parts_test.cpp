// Lines and points of scene files.
#include "oc_core/scene/loose_parts.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/scene/line_mesh.h"
#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/animated_gltf.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Of a glTF file whose one node scales by 2, with the mode of a primitive.
std::string primitiveFile(int mode, const std::string& material = "{}") {
  test::AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  return file.text(fmt::format(
      R"("scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0, "scale": [2, 2, 2]}}], "materials": [{}],
         "extensionsUsed": ["KHR_materials_unlit"],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}, "mode": {}, "material": 0}}]}}])",
      material, corners, mode));
}

TEST(LooseParts, AreTheLinesOfGltf) {
  const TemporaryFolder folder;
  // LINES, LINE_LOOP and LINE_STRIP of four corners
  for (const auto& [mode, segments] : {std::pair<int, size_t>{1, 2}, {2, 4}, {3, 3}}) {
    const Scene scene = readSceneFile(folder.write("a.gltf", primitiveFile(mode)));
    ASSERT_TRUE(scene.points.has_value());
    EXPECT_EQ(scene.points->lines, segments) << mode;
    EXPECT_EQ(scene.points->points, 0u);
    const Mesh mesh = flatten(scene);
    // Around a square of side 2, by half of the width.
    const float reach = static_cast<float>(kLineShare) * 2 * std::sqrt(2.0f) / 2;
    EXPECT_NEAR(boundsOf(mesh).upper.x, 2 + reach, 1e-4f);
    EXPECT_NEAR(boundsOf(mesh).upper.z, reach, 1e-4f);
    EXPECT_NEAR(boundsOf(flatten(readSceneFile(folder / "a.gltf", {.points = {.width = 0.5}}))).upper.z, 0.25f, 1e-4f);
  }
}

TEST(LooseParts, AreThePointsOfGltf) {
  const TemporaryFolder folder;
  const Scene scene = readSceneFile(folder.write("a.gltf", primitiveFile(0)), {.points = {.width = 0.25}});
  ASSERT_TRUE(scene.points.has_value());
  EXPECT_EQ(scene.points->points, 4u);
  EXPECT_EQ(scene.points->lines, 0u);
  const Box box = boundsOf(flatten(scene));
  EXPECT_GT(box.upper.x, 2.0f);
  EXPECT_LT(box.upper.x, 2.3f);
}

TEST(LooseParts, StandBesideTriangles) {
  const TemporaryFolder folder;
  const std::string square = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 3\n";
  const Scene scene = readSceneFile(folder.write("a.obj", square + "f 1 2 3 4\nl 1 5 3\n"));
  EXPECT_EQ(scene.points->lines, 2u);
  EXPECT_NEAR(boundsOf(flatten(scene)).upper.z, 3, 0.05f);
  EXPECT_TRUE(scene.warnings.empty());
  // One point alone has no size of its own.
  const Scene one = readSceneFile(folder.write("b.obj", square + "f 1 2 3 4\np 5\n"));
  EXPECT_THAT(one.warnings, ElementsAre(HasSubstr("--point-size")));
  EXPECT_EQ(triangleCount(one), 2u);
  EXPECT_THAT([&] { readSceneFile(folder.write("c.obj", square + "p 5\n")); },
              ThrowsMessage<InputError>(HasSubstr("--point-size")));
}

TEST(LooseParts, HaveTheColorsAndTheLightOfTheirMaterials) {
  const TemporaryFolder folder;
  const Scene lit = readSceneFile(
      folder.write("a.gltf", primitiveFile(3, R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}})")));
  EXPECT_EQ(lit.meshes.back().color(0), glm::vec3(1, 0.5f, 0));
  EXPECT_TRUE(unlitVertices(lit).empty());
  const Scene unlit =
      readSceneFile(folder.write("b.gltf", primitiveFile(3, R"({"extensions": {"KHR_materials_unlit": {}}})")));
  EXPECT_THAT(unlitVertices(unlit), testing::Each(1));
  EXPECT_EQ(unlitVertices(unlit).size(), flatten(unlit).positions.size());
}

}  // namespace
}  // namespace ocelli
