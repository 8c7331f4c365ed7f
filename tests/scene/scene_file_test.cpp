#include "oc_core/scene/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <ostream>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/solids.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr float kFloatStep = 1e-6f;  // a few roundings of numbers around 1

const std::string kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

/// Two nodes, one in the other, that show the same triangle; COLOR_0 and a base colour factor.
std::string gltfFile() {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "translation": [10, 0, 0], "children": [1]}, {"mesh": 0, "scale": [2, 2, 2]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}, "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 1, 1]}}],
    "buffers": [{"byteLength": 72, "uri": "triangle.bin"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 36}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"}]})";
}

std::string gltfBuffer() {
  const std::array<float, 18> values{0, 0, 0, 1, 0, 0, 0, 1, 0, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f};
  return {reinterpret_cast<const char*>(values.data()), sizeof(values)};
}

TEST(ReadSceneFile, SharesTheVerticesOfAnObj) {
  const TemporaryFolder folder;
  const Mesh cube = flatten(readSceneFile(folder.write("cube.obj", kCube)));
  EXPECT_EQ(cube.positions.size(), 8u);
  EXPECT_EQ(cube.triangles.size(), 12u);
  EXPECT_TRUE(cube.colors.empty()) << "the importer's grey default is no colour of the file";
  EXPECT_TRUE(isClosed(cube));
  EXPECT_DOUBLE_EQ(signedVolume(cube), 8.0);
}

TEST(ReadSceneFile, SharesTheVerticesOfAnStl) {
  const TemporaryFolder folder;
  const Mesh box = makeBox(glm::vec3(1));
  std::string stl = "solid box\n";
  for (const glm::uvec3& t : box.triangles) {
    stl += "facet normal 0 0 0\nouter loop\n";
    for (glm::length_t i = 0; i < 3; ++i) {
      const glm::vec3& p = box.positions[t[i]];
      stl += "vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    }
    stl += "endloop\nendfacet\n";
  }
  const Mesh read = flatten(readSceneFile(folder.write("box.stl", stl + "endsolid box\n")));
  EXPECT_EQ(read.positions.size(), 8u);
  EXPECT_TRUE(read.colors.empty());
  EXPECT_DOUBLE_EQ(signedVolume(read), 8.0);
}

TEST(ReadSceneFile, TakesObjVertexColorsAsSrgb) {
  const TemporaryFolder folder;
  const Mesh mesh = flatten(
      readSceneFile(folder.write("a.obj", "v 0 0 0 1.0 0.0 0.0\nv 1 0 0 0.0 0.5 0.0\nv 0 1 0 0.0 0.0 1.0\nf 1 2 3\n")));
  ASSERT_EQ(mesh.colors.size(), 3u);
  EXPECT_EQ(mesh.colors[0], glm::vec3(1, 0, 0));
  EXPECT_NEAR(mesh.colors[1].y, linearFromSrgb(0.5f), kFloatStep);
}

TEST(ReadSceneFile, TakesDiffuseColorsOfMaterialsAsSrgb) {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl red\nKd 1 0.5 0\nnewmtl blue\nKd 0 0 1\n");
  const Mesh mesh = flatten(readSceneFile(
      folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl blue\nf 3 2 1\n")));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_NEAR(glm::distance(mesh.color(mesh.triangles[0].x), {1, linearFromSrgb(0.5f), 0}), 0.0f, kFloatStep);
  EXPECT_EQ(mesh.color(mesh.triangles[1].x), glm::vec3(0, 0, 1));
}

TEST(ReadSceneFile, FlattensTheNodesOfGltfAndItsLinearColors) {
  const TemporaryFolder folder;
  folder.write("triangle.bin", gltfBuffer());
  const Scene scene = readSceneFile(folder.write("a.gltf", gltfFile()));
  EXPECT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.instances.size(), 2u);
  const Mesh flat = flatten(scene);
  ASSERT_EQ(flat.positions.size(), 6u);
  EXPECT_EQ(flat.positions[1], glm::vec3(11, 0, 0));
  EXPECT_EQ(flat.positions[4], glm::vec3(12, 0, 0));
  EXPECT_NEAR(glm::distance(flat.colors[4], {0.25f, 0.5f, 0.5f}), 0.0f, kFloatStep);
}

TEST(ReadSceneFile, LeavesUnusedVerticesOut) {
  const TemporaryFolder folder;
  const Mesh mesh = flatten(readSceneFile(folder.write("a.obj", "v 99 99 99\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n")));
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_LE(boundsOf(mesh).upper.x, 1.0f);
}

TEST(ReadSceneFile, KnowsPlyByItsFirstBytes) {
  const TemporaryFolder folder;
  const fs::path path =
      folder.write("mesh.dat",
                   "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
                   "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                   "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(triangleCount(readSceneFile(path)), 1u);
}

struct BadFile {
  std::string name;
  std::string bytes;
  std::string message;
};

// The parameter as tests are listed with it: without this, as raw bytes.
void PrintTo(const BadFile& file, std::ostream* out) {
  *out << file.name;
}

class LoadBadScene : public testing::TestWithParam<BadFile> {};

TEST_P(LoadBadScene, SaysWhichFileAndWhatToDo) {
  const TemporaryFolder folder;
  const fs::path path = folder.write(GetParam().name, GetParam().bytes);
  EXPECT_THAT([&] { loadScene(path.string()); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr(path.string()), HasSubstr("\n  try: "), HasSubstr(GetParam().message))));
}

INSTANTIATE_TEST_SUITE_P(
    Files, LoadBadScene,
    testing::Values(
        BadFile{"zero.obj", "", "empty"}, BadFile{"zero.ply", "", "empty"}, BadFile{"zero.glb", "", "empty"},
        BadFile{"nonsense.obj", std::string(1000, '\7'), ""}, BadFile{"nonsense.stl", std::string(1000, '\xff'), ""},
        BadFile{"nonsense.glb", std::string(1000, '\xff'), ""}, BadFile{"nonsense.xyz", std::string(1000, 'x'), ""},
        BadFile{"no_faces.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n# nothing else\n", ""},
        BadFile{"one_place.obj", "v 0 0 0\nv 1 0 0\nl 1 1\n", "no length"},
        BadFile{"nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not a finite number"},
        BadFile{"huge.obj", "v 1e60 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ""},
        BadFile{"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", ""},
        BadFile{"point.obj", "v 7 7 7\nv 7 7 7\nv 7 7 7\nf 1 2 3\n", "too small"},
        BadFile{"short.stl", std::string(80, ' ') + std::string("\x10\0\0\0", 4) + std::string(100, 'a'), ""},
        BadFile{"version.gltf", R"({"asset": {"version": "9.0"}})", ""},
        BadFile{"cut.gltf", R"({"asset": {"version": "2.0"}, "meshes": [{)", ""},
        BadFile{"no_buffer.gltf", gltfFile(), ""}),
    [](const auto& test) {
      std::string name = test.param.name;
      std::replace(name.begin(), name.end(), '.', '_');
      return name;
    });

TEST(LoadBadScene, MissingFileAndFolder) {
  const TemporaryFolder folder;
  const std::string missing = (folder.path() / "none.ply").string();
  EXPECT_THAT([&] { loadScene(missing); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(missing), HasSubstr("no such file"), HasSubstr("try:"))));
  EXPECT_THAT([&] { loadScene(folder.path().string()); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("this is a folder"), HasSubstr("--time"))));
  EXPECT_THROW(loadScene(""), InputError);
}

TEST(LoadScene, FitsAndShadesAsAsked) {
  const TemporaryFolder folder;
  const std::string path = folder.write("cube.obj", kCube).string();
  const Mesh raw = loadScene(path, {.fit = false, .shading = Shading::kNone});
  EXPECT_EQ(boundsOf(raw).upper, glm::vec3(1));
  EXPECT_TRUE(raw.colors.empty());
  const Mesh fitted = loadScene(path, {.shading = Shading::kNone});
  EXPECT_NEAR(glm::length(fitted.positions[0]), 1.0f, kFloatStep);
  const Mesh shaded = loadScene(path);
  EXPECT_EQ(shaded.colors.size(), shaded.positions.size());
  EXPECT_EQ(shaded.positions.size(), 24u);
}

}  // namespace
}  // namespace ocelli
