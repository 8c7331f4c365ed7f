#include "oc_core/scene/texture_bake.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;

const Rgb8 kRed(255, 0, 0);
const Rgb8 kBlue(0, 0, 255);

/// Red above, blue below; the top left pixel is green.
Texture makeTexture(int size) {
  Texture texture{Image<Rgb8>(size, size, kBlue)};
  for (int y = 0; y < size / 2; ++y) {
    for (int x = 0; x < size; ++x) {
      texture.image(x, y) = kRed;
    }
  }
  texture.image(0, 0) = {0, 255, 0};
  return texture;
}

/// The unit square of two triangles, all of the texture on it.
TexturedMesh square() {
  TexturedMesh part;
  part.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  part.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  part.base = TextureLayer{0, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  return part;
}

TEST(Texture, HasItsOriginAtTheLowerLeft) {
  const Texture texture = makeTexture(4);
  EXPECT_EQ(texture.sample({0.125f, 0.875f}), glm::vec3(0, 1, 0));
  EXPECT_EQ(texture.sample({0.625f, 0.875f}), glm::vec3(1, 0, 0));
  EXPECT_EQ(texture.sample({0.625f, 0.125f}), glm::vec3(0, 0, 1));
  EXPECT_EQ(texture.sample({0.625f, 0.5f}), glm::vec3(0.5f, 0, 0.5f)) << "half-way between pixels, in linear light";
}

TEST(Texture, Wraps) {
  Texture texture = makeTexture(4);
  EXPECT_EQ(texture.sample({3.125f, -1.125f}), glm::vec3(0, 1, 0));
  texture.wrapU = texture.wrapV = TextureWrap::kMirror;
  EXPECT_EQ(texture.sample({-0.125f, 1.125f}), glm::vec3(0, 1, 0));
  EXPECT_EQ(texture.sample({1.125f, 0.875f}), glm::vec3(1, 0, 0));
  texture.wrapU = texture.wrapV = TextureWrap::kClamp;
  EXPECT_EQ(texture.sample({-9, 9}), glm::vec3(0, 1, 0));
}

TEST(Texture, TakesCoordinatesThatAreNoPlaces) {
  const Texture texture = makeTexture(4);
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 3e38f}) {
    const glm::vec3 color = texture.sample({bad, bad});
    EXPECT_TRUE(glm::length(color) <= 2);
  }
}

TEST(Texture, HalvesInLinearLight) {
  Texture texture{Image<Rgb8>(3, 1, Rgb8(255, 255, 255))};
  texture.image(0, 0) = {0, 0, 0};
  const Texture half = texture.halved();
  EXPECT_EQ(half.image.width(), 2);
  EXPECT_EQ(half.image.height(), 1);
  EXPECT_EQ(half.image(0, 0).x, srgbByteFromLinear(0.5f));
  EXPECT_EQ(half.image(1, 0).x, 255);
}

TEST(BakeTextures, KeepsDetailThatIsFinerThanTheMesh) {
  std::vector<TexturedMesh> parts{square()};
  bakeTextures(parts, {makeTexture(16)}, 100'000);
  const Mesh& mesh = parts[0].mesh;
  EXPECT_GE(mesh.triangles.size(), 512u) << "two a pixel";
  EXPECT_NEAR(areaOf(mesh), 1.0, 1e-6);  // midpoints in binary fractions are exact; the sum of many is not
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    if (p.x > 0.2f && p.x < 0.9f && p.y > 0.6f && p.y < 0.9f) {
      EXPECT_EQ(mesh.colors[i], glm::vec3(1, 0, 0));
    }
    if (p.x > 0.2f && p.x < 0.9f && p.y > 0.1f && p.y < 0.4f) {
      EXPECT_EQ(mesh.colors[i], glm::vec3(0, 0, 1));
    }
  }
}

TEST(BakeTextures, BlursWhereItMayAddFewTriangles) {
  std::vector<TexturedMesh> parts{square()};
  bakeTextures(parts, {makeTexture(256)}, 600);
  EXPECT_LE(parts[0].mesh.triangles.size(), 2500u);
  EXPECT_GE(parts[0].mesh.triangles.size(), 300u);
  std::vector<TexturedMesh> none{square()};
  bakeTextures(none, {makeTexture(256)}, 0);
  EXPECT_EQ(none[0].mesh.triangles.size(), 2u);
}

TEST(BakeTextures, TellsHowMuchItKeeps) {
  const auto baked = [](size_t maxTriangles) {
    std::vector<TexturedMesh> parts{square()};
    const BakedTextures report = bakeTextures(parts, {makeTexture(64)}, maxTriangles);
    return std::pair(report, parts[0].mesh.triangles.size());
  };
  constexpr size_t kPixels = 64 * 64;
  // Of two triangles that are there; an edge of 64 pixels is split at each half of one, or at each one.
  const auto [fine, fineTriangles] = baked(8 * kPixels);
  EXPECT_EQ(fineTriangles, 8 * kPixels);
  EXPECT_EQ(fine.wanted, 2 * kPixels - 2);
  EXPECT_EQ(fine.halvings, 0);
  const auto [whole, wholeTriangles] = baked(2 * kPixels);
  EXPECT_EQ(wholeTriangles, 2 * kPixels);
  EXPECT_EQ(whole.halvings, 0);
  const auto [halved, halvedTriangles] = baked(2 * kPixels - 3);
  EXPECT_EQ(halvedTriangles, kPixels / 2);
  EXPECT_EQ(halved.halvings, 1);
  EXPECT_FALSE(halved.isCut);
  std::vector<TexturedMesh> repeated{square()};
  for (glm::vec2& uv : repeated[0].base->uvs) {
    uv *= 100.0f;
  }
  EXPECT_TRUE(bakeTextures(repeated, {makeTexture(64)}, 1000).isCut);
}

TEST(BakeTextures, AddsFewTrianglesAlsoWhereCoordinatesAreOutOfAllBounds) {
  for (const float bound : {1e4f, 1e9f, 1e18f, 1e30f}) {
    TexturedMesh part = square();
    part.base->uvs = {{0, 0}, {bound, 0}, {bound, bound}, {0, bound}};
    std::vector<TexturedMesh> parts{part, part};
    bakeTextures(parts, {makeTexture(16)}, 500);
    // The last round may split each edge of every triangle.
    EXPECT_LE(parts[0].mesh.triangles.size() + parts[1].mesh.triangles.size(), size_t{4 * (500 + 4)}) << bound;
  }
}

TEST(BakeTextures, SplitsBothSidesOfASeamAlike) {
  // Two triangles that meet in an edge of four vertices; only one of them has any texture along it.
  TexturedMesh part;
  part.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  part.mesh.triangles = {{0, 1, 2}, {3, 5, 4}};
  part.base = TextureLayer{0, {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {0, 0}, {0, 0}}};
  std::vector<TexturedMesh> parts{part};
  bakeTextures(parts, {makeTexture(8)}, 10'000);
  const auto onSeam = [](const glm::vec3& p) { return p.x + p.y == 1.0f; };
  size_t vertices = 0;
  for (const glm::vec3& p : parts[0].mesh.positions) {
    vertices += onSeam(p) ? 1 : 0;
  }
  EXPECT_EQ(vertices % 2, 0u) << "each place on the seam has a vertex on either side";
  EXPECT_GT(vertices, 16u);
}

TEST(BakeTextures, MultipliesTheColorThatIsThere) {
  std::vector<TexturedMesh> parts{square()};
  parts[0].mesh.colors.assign(4, glm::vec3(0.5f));
  Texture white{Image<Rgb8>(1, 1, Rgb8(255, 255, 255))};
  bakeTextures(parts, {white}, 0);
  EXPECT_EQ(parts[0].mesh.colors[0], glm::vec3(0.5f));
}

TEST(SceneFileTexture, ComesFromAPngBesideTheObj) {
  const TemporaryFolder folder;
  writePng(folder.path() / "t.png", makeTexture(16).image);
  folder.write("a.mtl", "newmtl tex\nKd 0 0 0\nmap_Kd t.png\n");
  const auto path = folder.write("a.obj",
                                 "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 "
                                 "1\nusemtl tex\nf 1/1 2/2 3/3 4/4\n");
  const Mesh mesh = flatten(readSceneFile(path));
  EXPECT_GE(mesh.triangles.size(), 512u);
  size_t red = 0;
  size_t blue = 0;
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    red += mesh.positions[i].y > 0.6f && mesh.colors[i] == glm::vec3(1, 0, 0);
    blue += mesh.positions[i].y < 0.4f && mesh.colors[i] == glm::vec3(0, 0, 1);
    EXPECT_FALSE(mesh.positions[i].y > 0.6f && mesh.positions[i].y < 0.9f && mesh.colors[i].z > 0.0f);
  }
  EXPECT_GT(red, 50u);
  EXPECT_GT(blue, 50u);
  EXPECT_EQ(triangleCount(readSceneFile(path, {.textures = false})), 2u);
}

}  // namespace
}  // namespace ocelli
