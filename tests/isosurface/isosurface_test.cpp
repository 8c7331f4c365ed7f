#include "oc_core/isosurface/isosurface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <random>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/scene/shading.h"
#include "oc_core/volume/builtin_volumes.h"
#include "tests/isosurface/field_volumes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

Mesh surfaceAt(const VolumeScene& scene, double value) {
  return isosurface(scene, {.value = value, .isShaded = false}, "the volume");
}

/// How often each edge is run along, less how often it is run along the other way.
std::map<std::pair<uint32_t, uint32_t>, int> openEdges(const Mesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (const glm::uvec3& t : mesh.triangles) {
    for (const auto& [from, to] : {std::pair(t.x, t.y), std::pair(t.y, t.z), std::pair(t.z, t.x)}) {
      edges[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }
  std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
  return edges;
}

/// Vertices less edges plus triangles: 2 for each closed surface without a hole through it.
int eulerCharacteristic(const Mesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (const glm::uvec3& t : mesh.triangles) {
    for (const auto& [a, b] : {std::pair(t.x, t.y), std::pair(t.y, t.z), std::pair(t.z, t.x)}) {
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  return static_cast<int>(mesh.positions.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(mesh.triangles.size());
}

double areaOf(const Mesh& mesh) {
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    area +=
        static_cast<double>(glm::length(areaNormal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]))) / 2;
  }
  return area;
}

/// Positive where the triangles run counter-clockwise seen from outside.
double enclosedVolume(const Mesh& mesh) {
  double volume = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]);
    const glm::dvec3 b(mesh.positions[t.y]);
    const glm::dvec3 c(mesh.positions[t.z]);
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return volume;
}

constexpr double kRadius = 10;
const glm::dvec3 kCenter(12.3, 11.8, 12.1);

/// Positive inside.
VolumeScene sphereScene() {
  return sceneOfField(glm::ivec3(25), [](const glm::dvec3& p) { return kRadius - glm::distance(p, kCenter); });
}

std::string errorOf(const VolumeScene& scene, double value) {
  try {
    surfaceAt(scene, value);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Isosurface, ASphereHasItsRadiusAndItsArea) {
  const Mesh mesh = surfaceAt(sphereScene(), 0);
  // The distance is convex along every axis, so that its interpolation is too large, by an eighth of the sum of its
  // second derivatives at the most: 2 / radius. The surface lies inside by that.
  const double deepest = 0.25 / (kRadius - 1);
  for (const glm::vec3& p : mesh.positions) {
    const double distance = glm::distance(glm::dvec3(p), kCenter);
    EXPECT_LE(distance, kRadius + 1e-3);
    EXPECT_GE(distance, kRadius - deepest - 1e-3);
  }
  const double whole = 4 * std::numbers::pi * kRadius * kRadius;
  EXPECT_LT(areaOf(mesh), whole);
  // Chords over about a voxel are shorter than their arcs by 1 / (24 radius^2), and the radius by the above.
  EXPECT_GT(areaOf(mesh), whole * 0.99);
}

TEST(Isosurface, TheSurfaceIsClosedAndItsOutsideHasLowerValues) {
  const Mesh mesh = surfaceAt(sphereScene(), 0);
  EXPECT_TRUE(openEdges(mesh).empty());
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
  EXPECT_NEAR(enclosedVolume(mesh), 4.0 / 3 * std::numbers::pi * std::pow(kRadius, 3), 60);  // 1.5 %
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 normal = areaNormal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
    EXPECT_GE(glm::dot(normal, mesh.positions[t.x] - glm::vec3(kCenter)), 0);
  }
}

TEST(Isosurface, AMirroringGridLeavesTheOutsideOutside) {
  const VolumeScene scene = sphereScene();
  glm::dmat4 mirror(1);
  mirror[0][0] = -2;
  mirror[3] = {5, 6, 7, 1};
  const Mesh mesh = surfaceAt(sceneOf(*scene.volume, mirror), 0);
  // The shorter diagonals of its quadrilaterals are others.
  const double wanted = 2 * enclosedVolume(surfaceAt(scene, 0));
  EXPECT_NEAR(enclosedVolume(mesh), wanted, 1e-3 * wanted);
}

TEST(Isosurface, TheBoxOfTheVolumeClosesWhatReachesItsFaces) {
  // Above 3.25 from x = 3.25 on: a block that ends at the faces of the box.
  const VolumeScene scene = sceneOfField({9, 7, 5}, [](const glm::dvec3& p) { return p.x; });
  const Mesh mesh = surfaceAt(scene, 3.25);
  EXPECT_TRUE(openEdges(mesh).empty());
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
  const Box box = boundsOf(mesh);
  for (const auto& [got, wanted] :
       {std::pair(box.lower, glm::vec3(3.25f, -0.5f, -0.5f)), std::pair(box.upper, glm::vec3(8.5f, 6.5f, 4.5f))}) {
    // The fit meets a linear field: what is left are roundings of floats of up to 9.
    EXPECT_LT(glm::distance(got, wanted), 1e-4) << got.x << " " << got.y << " " << got.z;
  }
  // Its edges are sharp.
  EXPECT_NEAR(enclosedVolume(mesh), 5.25 * 7 * 5, 1e-3);
}

TEST(Isosurface, OneVoxelIsASurface) {
  const VolumeScene scene = sceneOfField(glm::ivec3(3), [](const glm::dvec3& p) { return p == glm::dvec3(1) ? 1 : 0; });
  const Mesh mesh = surfaceAt(scene, 0.5);
  EXPECT_TRUE(openEdges(mesh).empty());
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
  EXPECT_GT(enclosedVolume(mesh), 0);
}

TEST(Isosurface, AVolumeMayBeThin) {
  for (const glm::ivec3& size : {glm::ivec3(1, 9, 9), glm::ivec3(9, 1, 9), glm::ivec3(9, 9, 1)}) {
    const VolumeScene scene = sceneOfField(size, [](const glm::dvec3& p) { return p.x + p.y + p.z; });
    const Mesh mesh = surfaceAt(scene, 7.5);
    EXPECT_TRUE(openEdges(mesh).empty());
    EXPECT_GT(enclosedVolume(mesh), 0);
  }
}

/// Of larger blocks than one, with every case that eight corners have.
VolumeScene noiseScene() {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0, 1);
  return sceneOfField({37, 23, 19}, [&](const glm::dvec3&) { return uniform(random); });
}

TEST(Isosurface, NoiseIsClosedToo) {
  for (const double value : {0.1, 0.5, 0.9}) {
    const Mesh mesh = surfaceAt(noiseScene(), value);
    EXPECT_GT(mesh.triangles.size(), 10000u);
    EXPECT_TRUE(openEdges(mesh).empty()) << value;
  }
}

TEST(Isosurface, BlocksThatTheSurfaceMissesAreInsideOrOutside) {
  // Thick enough for blocks that lie inside as a whole.
  const glm::dvec3 center(40);
  const VolumeScene scene =
      sceneOfField(glm::ivec3(81), [&](const glm::dvec3& p) { return 36 - glm::distance(p, center); });
  const Mesh mesh = surfaceAt(scene, 0);
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
  // Chords of a voxel lie up to 1 / (8 36) voxels within a circle of 36, 1e-4 of its radius, which makes 2e-4 of the
  // area; ten times that leaves room for facets of other shapes.
  EXPECT_NEAR(areaOf(mesh), 4 * std::numbers::pi * 36 * 36, 0.002 * 4 * std::numbers::pi * 36 * 36);
}

TEST(Isosurface, VerticesHaveTheValue) {
  BuiltinVolume made = makeBuiltinVolume("builtin:volume,name=marschner-lobb");
  const VolumeScene scene = sceneOf(std::move(made.volume));
  const Mesh mesh = surfaceAt(scene, 0.5);
  EXPECT_TRUE(openEdges(mesh).empty());
  const glm::vec3 last(scene.volume->grid().size - 1);
  size_t inside = 0;
  size_t near = 0;
  for (const glm::vec3& p : mesh.positions) {
    if (glm::all(glm::greaterThanEqual(p, glm::vec3(0))) && glm::all(glm::lessThanEqual(p, last))) {
      ++inside;
      // Of values from 0 to 1.
      near += std::abs(scene.volume->fieldAt(p) - 0.5) < 1e-3;
    }
  }
  EXPECT_GT(inside, 10000u);
  // Vertices in cells whose field turns over within the cell may stop short of it.
  EXPECT_GT(static_cast<double>(near), 0.99 * static_cast<double>(inside));
}

TEST(Isosurface, TypesOfVoxelsAndTheirScaleMeanTheSame) {
  const glm::ivec3 size(12);
  const std::vector<float> values = test::voxelsOf(
      size, [](const glm::dvec3& p) { return std::round(250 - 30 * glm::distance(p, glm::dvec3(5.5))); });
  std::vector<int16_t> stored;
  for (const float value : values) {
    stored.push_back(static_cast<int16_t>((value + 1024) / 2));
  }
  std::vector<float> meant;
  for (const int16_t value : stored) {
    meant.push_back(static_cast<float>(2 * value - 1024));
  }
  const ScalarVolume scaled({.size = size}, VoxelType::kInt16, std::as_bytes(std::span(stored)), nullptr, 2, -1024);
  const Mesh mesh = surfaceAt(sceneOf(scaled), 101);
  const Mesh wanted = surfaceAt(sceneOf(ScalarVolume({.size = size}, meant)), 101);
  EXPECT_EQ(mesh.positions, wanted.positions);
  EXPECT_EQ(mesh.triangles, wanted.triangles);
  EXPECT_FALSE(mesh.empty());
}

TEST(Isosurface, TheSameWithAnyNumberOfThreads) {
  const Mesh all = surfaceAt(noiseScene(), 0.5);
  setThreadCount(1);
  const Mesh one = surfaceAt(noiseScene(), 0.5);
  setThreadCount(0);
  EXPECT_EQ(all.positions, one.positions);
  EXPECT_EQ(all.triangles, one.triangles);
}

TEST(Isosurface, TheColourIsThatOfTheTransferFunction) {
  const Mesh mesh = surfaceAt(sphereScene(), 0);
  ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
  for (const glm::vec3& color : mesh.colors) {
    EXPECT_EQ(color, glm::vec3(0.25f, 0.5f, 1));
  }
}

TEST(Isosurface, ItIsLitAsMeshesAreByItsGradient) {
  const Mesh mesh = isosurface(sphereScene(), {.value = 0}, "the volume");
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const float wanted = lambertShade(glm::normalize(mesh.positions[i] - glm::vec3(kCenter)));
    // Differences of a distance over two voxels turn by up to about 1 / (2 radius^2).
    EXPECT_NEAR(mesh.colors[i].b, wanted, 0.01);
  }
}

TEST(Isosurface, ValuesOutsideOfTheRangeAreErrorsThatTellTheRange) {
  const VolumeScene scene = sceneOfField(glm::ivec3(4), [](const glm::dvec3& p) { return 10 + p.x; });
  EXPECT_THAT(errorOf(scene, 9), HasSubstr("its values run from 10 to 13"));
  EXPECT_THAT(errorOf(scene, 13), HasSubstr("its values run from 10 to 13"));
  EXPECT_THAT(errorOf(scene, 10), HasSubstr("no error"));
}

TEST(Isosurface, OneOfTooManyTrianglesIsAnErrorBeforeItIsMade) {
  const size_t triangles = surfaceAt(sphereScene(), 0).triangles.size();
  EXPECT_EQ(isosurface(sphereScene(), {.value = 0, .maxTriangles = triangles}, "the volume").triangles.size(),
            triangles);
  try {
    isosurface(sphereScene(), {.value = 0, .maxTriangles = triangles - 2}, "the volume");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("triangles that fit into memory"));
  }
}

TEST(Isosurface, AFlatFieldHasNone) {
  const VolumeScene scene = sceneOfField(glm::ivec3(4), [](const glm::dvec3&) { return 5; });
  EXPECT_THAT(errorOf(scene, 5), HasSubstr("all of its voxels have the value 5"));
}

TEST(Isosurface, VoxelsThatAreNoNumbersAreAnError) {
  const VolumeScene scene = sceneOfField(glm::ivec3(4), [](const glm::dvec3& p) {
    return p.x == 2 && p.y < 2 && p.z == 3 ? std::numeric_limits<double>::quiet_NaN() : p.z;
  });
  EXPECT_THAT(errorOf(scene, 1.5), HasSubstr("2 voxels of this volume are no numbers"));
}

}  // namespace
}  // namespace ocelli
