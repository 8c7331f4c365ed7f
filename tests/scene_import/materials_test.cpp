// Textures, emission and what moves texture coordinates, from files to the colours of vertices. Expected colours are by
// hand.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numbers>

#include "oc_core/image/color.h"
#include "oc_core/scene/import/assimp_scene.h"
#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr float kFloatStep = 1e-5f;  // some roundings of numbers around 1, and an sRGB curve

const Rgb8 kRed(255, 0, 0);
const Rgb8 kGreen(0, 255, 0);
const Rgb8 kBlue(0, 0, 255);
const Rgb8 kWhite(255, 255, 255);

/// red  green
/// blue white
Image<Rgb8> fourTexels() {
  Image<Rgb8> image(2, 2);
  image(0, 0) = kRed;
  image(1, 0) = kGreen;
  image(0, 1) = kBlue;
  image(1, 1) = kWhite;
  return image;
}

/// Four vertices at the centres of the texels of the image above, in reading order: (x, y) = (0, 1), (1, 1), (0, 0),
/// (1, 0). Without a transform, each has the colour of its texel.
class TexturedQuad : public testing::Test {
 protected:
  TexturedQuad() {
    writePng(folder_ / "four.png", fourTexels());
    const std::array<float, 20> values{0,    1,    0,    1,    1,    0,    0,    0,   0, 1, 0, 0,  // positions
                                       .25f, .25f, .75f, .25f, .25f, .75f, .75f, .75f};  // coordinates, v downwards
    const std::array<uint16_t, 6> corners{0, 2, 1, 1, 2, 3};
    folder_.write("quad.bin", std::string(reinterpret_cast<const char*>(values.data()), sizeof(values)) +
                                  std::string(reinterpret_cast<const char*>(corners.data()), sizeof(corners)));
  }

  /// `material` and `extensions` as JSON.
  fs::path write(const std::string& material, const std::string& image = "four.png") const {
    return folder_.write(
        "quad.gltf",
        fmt::format(
            R"({{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}],
          "extensionsUsed": ["KHR_texture_transform"],
          "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "TEXCOORD_0": 1}}, "indices": 2, "material": 0}}]}}],
          "materials": [{}], "textures": [{{"source": 0, "sampler": 0}}], "samplers": [{{}}], "images": [{{"uri": "{}"}}],
          "buffers": [{{"byteLength": 92, "uri": "quad.bin"}}],
          "bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48, "byteLength": 32}},
                          {{"buffer": 0, "byteOffset": 80, "byteLength": 12}}],
          "accessors": [
            {{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}},
            {{"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"}},
            {{"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}}]}})",
            material, image));
  }

  /// The colours of the four vertices, in reading order.
  std::vector<glm::vec3> colors(const std::string& material) const { return colorsOf(readSceneFile(write(material))); }

  static std::vector<glm::vec3> colorsOf(const Scene& scene) {
    const Mesh mesh = flatten(scene);
    std::vector<glm::vec3> found;
    for (const glm::vec3 place : {glm::vec3(0, 1, 0), glm::vec3(1, 1, 0), glm::vec3(0, 0, 0), glm::vec3(1, 0, 0)}) {
      for (uint32_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.positions[i] == place) {
          found.push_back(mesh.color(i));
        }
      }
    }
    return found;
  }

  static void expectColors(const std::vector<glm::vec3>& got, const std::vector<glm::vec3>& wanted) {
    ASSERT_EQ(got.size(), wanted.size());
    for (size_t i = 0; i < got.size(); ++i) {
      EXPECT_NEAR(glm::distance(got[i], wanted[i]), 0, kFloatStep)
          << "vertex " << i << ": " << got[i].x << " " << got[i].y << " " << got[i].z;
    }
  }

  TemporaryFolder folder_;
};

constexpr glm::vec3 kLinearRed(1, 0, 0);
constexpr glm::vec3 kLinearGreen(0, 1, 0);
constexpr glm::vec3 kLinearBlue(0, 0, 1);
constexpr glm::vec3 kLinearWhite(1);

std::string baseTexture(const std::string& transform) {
  return fmt::format(
      R"({{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0, "extensions": {{"KHR_texture_transform": {}}}}}}}}})",
      transform);
}

TEST_F(TexturedQuad, HasItsTexelsWithoutATransform) {
  expectColors(colors(baseTexture("{}")), {kLinearRed, kLinearGreen, kLinearBlue, kLinearWhite});
}

TEST_F(TexturedQuad, IsMovedByAnOffset) {
  // Half a texture to the right: red shows what was at its right.
  expectColors(colors(baseTexture(R"({"offset": [0.5, 0]})")), {kLinearGreen, kLinearRed, kLinearWhite, kLinearBlue});
  expectColors(colors(baseTexture(R"({"offset": [0, 0.5]})")), {kLinearBlue, kLinearWhite, kLinearRed, kLinearGreen});
}

TEST_F(TexturedQuad, IsTurnedByAQuarterAboutTheTopLeft) {
  // (u, v) becomes (v, -u): (.25, .25) is (.25, -.25), which is blue; (.75, .25) is (.25, -.75), red; and so on.
  expectColors(colors(baseTexture(fmt::format(R"({{"rotation": {}}})", std::numbers::pi / 2))),
               {kLinearBlue, kLinearRed, kLinearWhite, kLinearGreen});
}

TEST_F(TexturedQuad, IsScaledDifferentlyAlongEachAxisAndThenTurned) {
  // (u, v) becomes (3 v, -u) + (0, 1): (.25, .25) is (.75, .75), white; (.75, .25) is (.75, .25), green; (.25, .75) is
  // (2.25, .75), blue; (.75, .75) is (2.25, .25), red.
  expectColors(colors(baseTexture(
                   fmt::format(R"({{"offset": [0, 1], "rotation": {}, "scale": [1, 3]}})", std::numbers::pi / 2))),
               {kLinearWhite, kLinearGreen, kLinearBlue, kLinearRed});
}

TEST_F(TexturedQuad, IsMirroredByANegativeScale) {
  // The other example of the extension: the origin at the bottom left.
  expectColors(colors(baseTexture(R"({"offset": [0, 1], "scale": [1, -1]})")),
               {kLinearBlue, kLinearWhite, kLinearRed, kLinearGreen});
}

TEST_F(TexturedQuad, AddsTheEmissiveTextureTimesItsFactor) {
  expectColors(
      colors(R"({"pbrMetallicRoughness": {"baseColorFactor": [0.25, 0.25, 0.25, 1]}, "emissiveFactor": [0.5, 0.25, 0],
                          "emissiveTexture": {"index": 0}})"),
      {{0.75f, 0.25f, 0.25f}, {0.25f, 0.5f, 0.25f}, {0.25f, 0.25f, 0.25f}, {0.75f, 0.5f, 0.25f}});
}

TEST_F(TexturedQuad, MovesTheEmissiveTextureByItself) {
  expectColors(colors(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "emissiveFactor": [1, 1, 1],
                          "emissiveTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"offset": [0.5, 0]}}}})"),
               {{1, 1, 0}, {1, 1, 0}, kLinearWhite, kLinearWhite});
}

TEST_F(TexturedQuad, EmitsWithoutATexture) {
  expectColors(colors(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "emissiveFactor": [0, 0.5, 0]})"),
               {{1, 0.5f, 0}, kLinearGreen, {0, 0.5f, 1}, kLinearWhite});
}

TEST_F(TexturedQuad, HasItsPlainColorAndAWarningWhereTheTextureIsMissing) {
  const Scene scene = readSceneFile(
      write(R"({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 1, 1], "baseColorTexture": {"index": 0}}})",
            "Q:/tex/none.png"));
  const glm::vec3 plain(0.5f, 1, 1);
  expectColors(colorsOf(scene), {plain, plain, plain, plain});
  EXPECT_THAT(scene.warnings, ElementsAre(AllOf(HasSubstr("quad.gltf"), HasSubstr("Q:/tex/none.png"),
                                                HasSubstr("missing"), HasSubstr("\n  try: "))));
}

TEST_F(TexturedQuad, FindsTheTextureOfAnotherMachine) {
  const Scene scene =
      readSceneFile(write(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})", "Q:\\\\tex\\\\FOUR.png"));
  expectColors(colorsOf(scene), {kLinearRed, kLinearGreen, kLinearBlue, kLinearWhite});
  EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(TexturedQuad, WarnsOfATextureThatIsNoImage) {
  folder_.write("four.png", "\x89PNG\r\n\x1a\nrubbish");
  const Scene scene = readSceneFile(write(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})"));
  EXPECT_THAT(scene.warnings, ElementsAre(AllOf(HasSubstr("four.png"), HasSubstr("--no-textures"))));
  EXPECT_EQ(readSceneFile(write(baseTexture("{}")), {.textures = false}).warnings.size(), 0u);
}

TEST(ObjMaterial, EmitsItsColorAndTakesAnEmissiveMapWithoutOneAsItIs) {
  const TemporaryFolder folder;
  writePng(folder / "glow.png", Image<Rgb8>(1, 1, Rgb8(0, 255, 0)));
  folder.write("a.mtl", "newmtl color\nKd 0.5 0 0\nKe 0 0 1\nnewmtl map\nKd 1 0 0\nmap_Ke glow.png\n");
  const auto colorWith = [&](const std::string& material) {
    const fs::path path = folder.write(
        "a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl " + material + "\nf 1/1 2/1 3/1\n");
    return flatten(readSceneFile(path)).color(0);
  };
  EXPECT_NEAR(glm::distance(colorWith("color"), {linearFromSrgb(0.5f), 0, 1}), 0, kFloatStep);
  EXPECT_NEAR(glm::distance(colorWith("map"), {1, 1, 0}), 0, kFloatStep);
}

TEST(ObjMaterial, WarnsOfManyTexturesInFewLines) {
  const TemporaryFolder folder;
  std::string materials;
  std::string mesh = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
  for (int i = 0; i < 30; ++i) {
    materials += fmt::format("newmtl m{}\nmap_Kd none{}.png\n", i, i);
    mesh += fmt::format("usemtl m{}\nf 1/1 2/1 3/1\n", i);
  }
  folder.write("a.mtl", materials);
  const Scene scene = readSceneFile(folder.write("a.obj", mesh));
  ASSERT_EQ(scene.warnings.size(), 21u);
  EXPECT_THAT(scene.warnings.back(), HasSubstr("10 more textures"));
}

TEST(ObjMaterial, OneWarningATexture) {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl a\nmap_Kd none.png\nnewmtl b\nmap_Kd -clamp on none.png\n");
  const fs::path path = folder.write(
      "a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 3/1 2/1 1/1\n");
  EXPECT_EQ(readSceneFile(path).warnings.size(), 1u);
}

}  // namespace
}  // namespace ocelli
