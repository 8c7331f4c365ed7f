// Pictures of scene files of many formats, which the tests write themselves: each beside the same thing in another
// format, or by hand (file_pictures.h).
#include "tests/render/file_pictures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "oc_core/worlds/scene_source.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/animated_gltf.h"

namespace ocelli {
namespace {

using test::AnimatedGltf;
using test::covered;
using test::differences;
using test::kSide;
using test::Picture;
using test::pictureOf;
using test::pictureOfFile;
using test::pixelsOfUnit;
using test::TemporaryFolder;

template <class Value>
void putBytes(std::string& bytes, Value value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// A hill over a square of so many vertices a side.
struct Hill {
  static constexpr uint32_t kVertices = 40;
  static glm::vec3 place(uint32_t i) {
    const glm::vec2 p = glm::vec2(i % kVertices, i / kVertices) / static_cast<float>(kVertices - 1) * 2.0f - 1.0f;
    return {p.x, p.y, 0.8f * std::exp(-4 * glm::dot(p, p))};
  }
  static std::array<uint8_t, 3> color(uint32_t i) {
    return {static_cast<uint8_t>(i % kVertices * 6), 160, static_cast<uint8_t>(i / kVertices * 6)};
  }
  static std::string plyVertices() {
    std::string text = fmt::format("element vertex {}\n", kVertices * kVertices);
    for (const char* name : {"float x", "float y", "float z", "uchar red", "uchar green", "uchar blue"}) {
      text += fmt::format("property {}\n", name);
    }
    return text;
  }
  static std::string plyRows() {
    std::string bytes;
    for (uint32_t i = 0; i < kVertices * kVertices; ++i) {
      putBytes(bytes, place(i));
      putBytes(bytes, color(i));
    }
    return bytes;
  }
};

constexpr const char* kPlyStart = "ply\nformat binary_little_endian 1.0\n";

TEST(FilePictures, StripsOfPlyAreItsFaces) {
  const TemporaryFolder folder;
  constexpr uint32_t kN = Hill::kVertices;
  std::string faces;
  std::string strips;
  uint32_t faceCount = 0;
  uint32_t corners = 0;
  for (uint32_t y = 0; y + 1 < kN; ++y) {
    for (uint32_t x = 0; x < kN; ++x) {
      const uint32_t low = y * kN + x;
      for (const uint32_t corner : {low + kN, low}) {
        putBytes(strips, corner);
      }
      corners += 3;
      if (x + 1 < kN) {
        for (const glm::uvec3& t : {glm::uvec3(low + kN, low, low + kN + 1), glm::uvec3(low + kN + 1, low, low + 1)}) {
          faces += '\3';
          putBytes(faces, t);
          ++faceCount;
        }
      }
    }
    corners -= kN - 1;
    putBytes(strips, int32_t{-1});
  }
  std::string list;
  putBytes(list, corners);
  const auto path = folder.write("strips.ply", kPlyStart + Hill::plyVertices() +
                                                   "element tristrips 1\nproperty list int int vertex_indices\n"
                                                   "end_header\n" +
                                                   Hill::plyRows() + list + strips);
  const auto same = folder.write("faces.ply", kPlyStart + Hill::plyVertices() +
                                                  fmt::format("element face {}\nproperty list uchar int "
                                                              "vertex_indices\nend_header\n",
                                                              faceCount) +
                                                  Hill::plyRows() + faces);
  const Picture drawn = pictureOfFile(path, {}, "ply_strips");
  EXPECT_EQ(differences(drawn, pictureOfFile(same, {}, "ply_faces")), 0u);
  EXPECT_GT(covered(drawn), 5000u);
}

TEST(FilePictures, PointsOfPcdAreThoseOfPly) {
  const TemporaryFolder folder;
  const auto ply = folder.write("points.ply", kPlyStart + Hill::plyVertices() + "end_header\n" + Hill::plyRows());
  std::string rows;
  for (uint32_t i = 0; i < Hill::kVertices * Hill::kVertices; ++i) {
    putBytes(rows, Hill::place(i));
    const auto [r, g, b] = Hill::color(i);
    putBytes(rows, static_cast<uint32_t>(r << 16 | g << 8 | b));
  }
  const auto pcd = folder.write(
      "points.pcd", fmt::format("VERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH {0}\n"
                                "HEIGHT {0}\nPOINTS {1}\nDATA binary\n",
                                Hill::kVertices, Hill::kVertices * Hill::kVertices) +
                        rows);
  const Picture drawn = pictureOfFile(pcd, {}, "pcd_points");
  EXPECT_EQ(differences(drawn, pictureOfFile(ply, {}, "ply_points")), 0u);
  EXPECT_GT(covered(drawn), 5000u);
}

/// A square from -1 to 1 with a texture `image.tga`, and one material.
std::string squareFile(const std::string& material) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
  const int uvs = file.floats("VEC2", {0, 1, 1, 1, 1, 0, 0, 0});
  const int triangles = file.shorts("SCALAR", {0, 1, 2, 0, 2, 3});
  return file.text(fmt::format(
      R"("scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}], "extensionsUsed": ["KHR_materials_unlit"],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}, "TEXCOORD_0": {}}}, "indices": {}, "material": 0}}]}}],
         "images": [{{"uri": "image.tga"}}], "textures": [{{"source": 0}}], "materials": [{}])",
      corners, uvs, triangles, material));
}

constexpr int kTexels = 128;

/// Its alpha falls from 255 in the middle by 255 over half of the side; green, and black where that is 0.
std::string tgaWithDisc() {
  std::string bytes{0, 0,  2, 0, 0, 0, 0, 0, 0, 0, 0, 0, static_cast<char>(kTexels), 0, static_cast<char>(kTexels),
                    0, 32, 8};
  for (int y = 0; y < kTexels; ++y) {
    for (int x = 0; x < kTexels; ++x) {
      const double distance = std::hypot(x + 0.5 - kTexels / 2.0, y + 0.5 - kTexels / 2.0) / (kTexels / 2.0);
      const int alpha = static_cast<int>(std::lround(255 * std::max(0.0, 1 - distance)));
      for (const int channel : {0, alpha > 0 ? 255 : 0, 0, alpha}) {
        bytes += static_cast<char>(channel);
      }
    }
  }
  return bytes;
}

/// Every pixel farther than `margin` pixels from the rim of a disc is covered or not, as it lies in the disc.
void expectDisc(const Picture& picture, float radius, float margin) {
  const float pixels = pixelsOfUnit();
  size_t wrong = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const float distance =
          std::hypot(static_cast<float>(x) + 0.5f - kSide / 2.0f, static_cast<float>(y) + 0.5f - kSide / 2.0f);
      const bool isIn = picture(x, y) != glm::vec3(0);
      wrong += (distance < radius * pixels - margin && !isIn) || (distance > radius * pixels + margin && isIn) ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(FilePictures, MasksOfGltfAreCutOut) {
  const TemporaryFolder folder;
  folder.write("image.tga", tgaWithDisc());
  const std::string texture = R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 0})";
  const SceneOptions plain{.fit = false, .shading = Shading::kNone};
  const auto drawn = [&](const std::string& rest, const std::string& name) {
    return pictureOfFile(folder.write("a.gltf", squareFile("{" + texture + rest)), plain, name);
  };
  // A pixel of the picture is as wide as three texels: half of one, and what a byte of alpha rounds, are less than one.
  expectDisc(drawn(R"(}, "alphaMode": "MASK"})", "gltf_mask"), 0.5f, 1);
  expectDisc(drawn(R"(}, "alphaMode": "MASK", "alphaCutoff": 0.2})", "gltf_mask_low"), 0.8f, 1);
  expectDisc(
      drawn(R"(, "baseColorFactor": [1, 1, 1, 0.8]}, "alphaMode": "MASK", "alphaCutoff": 0.2})", "gltf_mask_factor"),
      0.75f, 1);
  expectDisc(drawn(R"(}, "alphaMode": "BLEND"})", "gltf_blend"), 0.5f, 1);
  // Without a mode it is opaque: green wherever the texture is, and black beyond, which is not counted. Between texels
  // green reaches a texel farther, along a diagonal the square root of 2.
  const double green = static_cast<double>(covered(drawn(R"(}})", "gltf_opaque")));
  const double radius = std::sqrt(green / 3.14159265) / static_cast<double>(pixelsOfUnit());
  EXPECT_GT(radius, 1 - 2.0 / kTexels);
  EXPECT_LT(radius, 1 + 2.0 * 1.4143 / kTexels);
}

TEST(FilePictures, MapsOfOpacityOfObjAreCutOut) {
  const TemporaryFolder folder;
  folder.write("image.tga", tgaWithDisc());
  folder.write("a.mtl", "newmtl m\nKd 1 1 1\nmap_d image.tga\n");
  const auto path =
      folder.write("a.obj",
                   "mtllib a.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                   "usemtl m\nf 1/1 2/2 3/3 4/4\n");
  expectDisc(pictureOfFile(path, {.fit = false, .shading = Shading::kNone}, "obj_opacity"), 0.5f, 1);
}

TEST(FilePictures, UnlitMaterialsKeepTheirColors) {
  const TemporaryFolder folder;
  const glm::vec3 color(0.5f, 0.25f, 1);
  const auto drawn = [&](const std::string& extensions, const std::string& name) {
    const auto path = folder.write(
        "a.gltf", squareFile(R"({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1]})" + extensions + "}"));
    return pictureOfFile(path, {.fit = false}, name)(kSide / 2, kSide / 2);
  };
  EXPECT_LT(glm::distance(drawn(R"(, "extensions": {"KHR_materials_unlit": {}})", "gltf_unlit"), color), 1e-5f);
  EXPECT_LT(drawn("", "gltf_lit").z, 0.95f) << "the light does not face it";
}

/// A strip of two squares from (0, 0) to (0.5, 1), whose upper edge belongs to a bone at (0.25, 0.5), which turns by 90
/// degrees in a second.
std::string bendingFile(const std::string& material) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 0, 0.5f, 0, 0, 0, 0.5f, 0, 0.5f, 0.5f, 0, 0, 1, 0, 0.5f, 1, 0});
  const int triangles = file.shorts("SCALAR", {0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4});
  std::vector<uint16_t> bones;
  std::vector<float> shares;
  for (int i = 0; i < 6; ++i) {
    bones.insert(bones.end(), {static_cast<uint16_t>(i < 4 ? 0 : 1), 0, 0, 0});
    shares.insert(shares.end(), {1, 0, 0, 0});
  }
  const int joints = file.shorts("VEC4", bones);
  const int weights = file.floats("VEC4", shares);
  const int inverse = file.floats("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,      0,     0, 1,
                                           1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -0.25f, -0.5f, 0, 1});
  const int times = file.floats("SCALAR", {0, 1});
  const int keys = file.floats("VEC4", {0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f});
  return file.text(fmt::format(
      R"("scenes": [{{"nodes": [0, 2]}}], "materials": [{}], "extensionsUsed": ["KHR_materials_unlit"],
         "nodes": [{{"name": "low", "children": [1]}}, {{"name": "high", "translation": [0.25, 0.5, 0]}},
                   {{"name": "body", "mesh": 0, "skin": 0}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}, "JOINTS_0": {}, "WEIGHTS_0": {}}}, "indices": {}, "material": 0}}]}}],
         "skins": [{{"joints": [0, 1], "inverseBindMatrices": {}}}],
         "animations": [{{"samplers": [{{"input": {}, "output": {}}}],
                          "channels": [{{"sampler": 0, "target": {{"node": 1, "path": "rotation"}}}}]}}])",
      material, corners, joints, weights, triangles, inverse, times, keys));
}

TEST(FilePictures, SkinsOfGltfBendInTime) {
  const TemporaryFolder folder;
  const std::string red =
      R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}, "extensions": {"KHR_materials_unlit": {}}})";
  const auto path = folder.write("a.gltf", bendingFile(red));
  for (const double seconds : {0.0, 0.4, 1.0}) {
    // By hand: (0, 1) and (0.5, 1) turned about (0.25, 0.5).
    const double angle = seconds * 1.5707963;
    const auto turned = [&](double x) {
      return glm::vec3(0.25 + (x - 0.25) * std::cos(angle) - 0.5 * std::sin(angle),
                       0.5 + (x - 0.25) * std::sin(angle) + 0.5 * std::cos(angle), 0);
    };
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0}, {0.5f, 0.5f, 0}, turned(0), turned(0.5)};
    mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}};
    mesh.colors.assign(6, {1, 0, 0});
    SceneOptions options{.fit = false};
    options.motion.seconds = seconds;
    const Picture drawn = pictureOfFile(path, options, fmt::format("gltf_skin_{}", seconds));
    // A pixel whose centre lies on an edge may fall to either side, as bones round.
    EXPECT_LE(differences(drawn, pictureOf(mesh, "by_hand")), 4u) << seconds;
    EXPECT_GT(covered(drawn), 300u);
  }
}

TEST(FilePictures, LinesAreAsWideAsTheyAreToldToBe) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.obj", "v -1 0 0\nv 1 0 0\nl 1 2\n");
  for (const double width : {0.1, 0.4}) {
    SceneOptions options{.fit = false, .shading = Shading::kNone};
    options.points.width = width;
    const Picture drawn = pictureOfFile(path, options, fmt::format("obj_line_{}", width));
    int rows = 0;
    for (int y = 0; y < kSide; ++y) {
      rows += drawn(kSide / 2, y) != glm::vec3(0) ? 1 : 0;
    }
    // Its sides are flat between eight corners on the circle: from cos(22.5 degrees) of the width on. It is nearer by
    // half of that.
    const double most = width * static_cast<double>(pixelsOfUnit()) * 10 / (10 - width / 2);
    EXPECT_LE(rows, most + 1);
    EXPECT_GE(rows, most * 0.92 - 1);
  }
}

}  // namespace
}  // namespace ocelli
