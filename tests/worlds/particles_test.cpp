// `builtin:particles` and `builtin:tree`: scenes with far more detail than pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "oc_core/scene/object_boxes.h"
#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/leafy_tree.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

TEST(Particles, AreSquaresInTheBallsOfTheirClusters) {
  const Scene scene = makeBuiltinScene("builtin:particles,clusters=3,count=500,seed=9");
  ASSERT_EQ(scene.meshes.size(), 4u);
  for (size_t cluster = 1; cluster < 4; ++cluster) {
    EXPECT_EQ(scene.instances[cluster].object, cluster);
    const Mesh& mesh = scene.meshes[cluster];
    ASSERT_EQ(mesh.triangles.size(), 1000u);
    glm::vec3 middle(0);
    for (size_t i = 0; i < mesh.positions.size(); i += 4) {
      const glm::vec3 along = mesh.positions[i + 1] - mesh.positions[i];
      const glm::vec3 up = mesh.positions[i + 3] - mesh.positions[i];
      // Coordinates are below 1, so that differences are right to 1e-7, and sides are 0.15 long.
      EXPECT_NEAR(glm::dot(along, up), 0, 1e-6f);
      EXPECT_NEAR(glm::length(along), glm::length(up), 1e-6f);
      EXPECT_NEAR(
          glm::length(mesh.positions[i] + mesh.positions[i + 2] - mesh.positions[i + 1] - mesh.positions[i + 3]), 0,
          1e-6f);
      middle += (mesh.positions[i] + mesh.positions[i + 2]) / 1000.0f;
      for (size_t corner = i; corner < i + 4; ++corner) {
        EXPECT_LE(glm::length(mesh.positions[corner]), 1 + 1e-6f);
        EXPECT_EQ(mesh.colors[corner], mesh.colors[i]);
      }
    }
    // Of 500 even places in the ball, whose deviation is 0.45 along each axis: four times that of their mean.
    EXPECT_LT(glm::length(middle), 4 * 0.45f * std::sqrt(3.0f / 500));
  }
}

/// How far `place` is above the triangle of a terrain that is below or above it, along y; nothing where there is none.
std::optional<float> heightAbove(const Mesh& terrain, const glm::vec3& place) {
  const auto areaFrom = [](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
  };
  for (const glm::uvec3& triangle : terrain.triangles) {
    const glm::vec3& a = terrain.positions[triangle.x];
    const glm::vec3& b = terrain.positions[triangle.y];
    const glm::vec3& c = terrain.positions[triangle.z];
    const glm::vec3 weights =
        glm::vec3(areaFrom(b, c, place), areaFrom(c, a, place), areaFrom(a, b, place)) / areaFrom(a, b, c);
    if (std::min({weights.x, weights.y, weights.z}) >= 0) {
      return place.y - glm::dot(weights, glm::vec3(a.y, b.y, c.y));
    }
  }
  return std::nullopt;
}

TEST(Particles, FloatAboveTheTerrain) {
  for (const char* source :
       {"builtin:particles,clusters=6,radius=0.14,count=100", "builtin:particles,clusters=6,radius=0.3,count=100",
        "builtin:particles,clusters=1,radius=0.3,count=100", "builtin:particles,clusters=2,radius=0.01,count=100"}) {
    const Scene scene = makeBuiltinScene(source);
    const Mesh& terrain = scene.meshes[0];
    const glm::mat4 terrainFromWorld = glm::inverse(scene.instances[0].worldFromMesh);
    size_t above = 0;
    for (size_t i = 1; i < scene.instances.size(); ++i) {
      const glm::mat4 terrainFromCluster = terrainFromWorld * scene.instances[i].worldFromMesh;
      for (const glm::vec3& corner : scene.meshes[i].positions) {
        const std::optional<float> height = heightAbove(terrain, glm::vec3(terrainFromCluster * glm::vec4(corner, 1)));
        EXPECT_GT(height.value_or(1), 0) << source << ", cluster " << i;
        above += height ? 1 : 0;
      }
    }
    EXPECT_GT(above, 400 * (scene.instances.size() - 1) * 9 / 10) << source << ": few are beside the terrain";
  }
}

TEST(Particles, FloatApartFromEachOther) {
  const GuidedScene scene = loadGuidedScene("builtin:particles,clusters=6,radius=0.14,count=2000");
  const std::map<uint32_t, Box> boxes = boxesOfObjects(scene.mesh, scene.objectOfTriangle);
  ASSERT_EQ(boxes.size(), 7u);
  for (uint32_t i = 1; i < 7; ++i) {
    for (uint32_t j = i + 1; j < 7; ++j) {
      const Box& a = boxes.at(i);
      const Box& b = boxes.at(j);
      EXPECT_TRUE(a.upper.x < b.lower.x || b.upper.x < a.lower.x || a.upper.z < b.lower.z || b.upper.z < a.lower.z);
    }
  }
  EXPECT_EQ(triangleCount(makeBuiltinScene("builtin:particles,count=1000000")), 2u * 2 * 1'000'000 + 600);
}

TEST(Particles, FollowTheSeed) {
  const auto places = [](const char* source) { return flatten(makeBuiltinScene(source)).positions; };
  EXPECT_EQ(places("builtin:particles,count=50,seed=4"), places("builtin:particles,count=50,seed=4"));
  EXPECT_NE(places("builtin:particles,count=50,seed=4"), places("builtin:particles,count=50,seed=5"));
}

TEST(LeafyTree, HasTheTrianglesAskedForAndASolidTrunk) {
  const Mesh wood = makeLeafyTree(minTreeTriangles(), 3);
  EXPECT_EQ(wood.triangles.size(), minTreeTriangles());
  Mesh trunk = wood;
  trunk.triangles.pop_back();  // its one leaf
  EXPECT_TRUE(isClosed(trunk));
  EXPECT_GT(signedVolume(trunk), 0);
  for (const size_t triangles : {2000u, 2001u, 9000u, 100'000u}) {
    const Mesh tree = makeLeafyTree(triangles, 3);
    EXPECT_EQ(tree.triangles.size(), triangles);
    // Leaves have the same area together, whatever their number; each is folded by a little.
    EXPECT_NEAR(areaOf(tree) - areaOf(trunk), 4.2, 0.4) << triangles;
    EXPECT_GE(boundsOf(tree).lower.y, -1e-6f) << "it stands on the ground";
  }
}

TEST(BuiltinTree, IsAnObjectOnALawn) {
  const GuidedScene scene = loadGuidedScene("builtin:tree");
  const std::map<uint32_t, Box> boxes = boxesOfObjects(scene.mesh, scene.objectOfTriangle);
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_GT(boxes.at(1).upper.y, boxes.at(0).upper.y);
  EXPECT_EQ(std::ranges::count(scene.objectOfTriangle, 1u), 9000);
}

}  // namespace
}  // namespace ocelli
