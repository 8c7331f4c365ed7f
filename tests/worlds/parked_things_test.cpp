#include "oc_core/worlds/parked_things.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "oc_core/scene/scene.h"
#include "oc_core/worlds/builtin_scenes.h"

namespace ocelli {
namespace {

TEST(ParkedThings, standOnTheGround) {
  const Mesh car = makeCar();
  const Mesh barrel = makeBarrel();
  for (const Mesh& mesh : {car, barrel}) {
    EXPECT_NO_THROW(validate(mesh, "a thing"));
    EXPECT_NEAR(boundsOf(mesh).lower.y, 0, 1e-6f);
    // Symmetric to the left and the right, but for side mirrors of the same shape.
    EXPECT_NEAR(boundsOf(mesh).lower.z, -boundsOf(mesh).upper.z, 1e-3f);
    EXPECT_LT(mesh.triangles.size(), 4000u);
  }
  EXPECT_NEAR(boundsOf(car).size().x, 4.6f, 0.1f);
  EXPECT_NEAR(boundsOf(car).size().y, 1.4f, 0.01f);
  EXPECT_NEAR(boundsOf(barrel).size().y, 0.9f, 1e-5f);
}

// The rear bumper stands out behind a gap: a line straight down passes between it and the body.
TEST(ParkedThings, theBumperStandsOut) {
  const Mesh car = makeCar();
  const auto trianglesAt = [&](float x, float z) {
    size_t covered = 0;
    for (const glm::uvec3& t : car.triangles) {
      const auto side = [&](const glm::vec3& a, const glm::vec3& b) {
        return (b.x - a.x) * (z - a.z) - (b.z - a.z) * (x - a.x);
      };
      const float p = side(car.positions[t.x], car.positions[t.y]);
      const float q = side(car.positions[t.y], car.positions[t.z]);
      const float r = side(car.positions[t.z], car.positions[t.x]);
      covered += (p > 0 && q > 0 && r > 0) || (p < 0 && q < 0 && r < 0);
    }
    return covered;
  };
  EXPECT_GT(trianglesAt(-2.26f, 0.11f), 0u);
  EXPECT_EQ(trianglesAt(-2.16f, 0.11f), 0u);
  EXPECT_GT(trianglesAt(-2.05f, 0.11f), 0u);
}

// Every edge of a barrel belongs to two faces, once in each direction: it is closed, and its outside is outside.
TEST(ParkedThings, theBarrelIsClosed) {
  const Mesh barrel = makeBarrel();
  const auto key = [&](uint32_t vertex) {
    const glm::vec3 p = barrel.positions[vertex] * 1e4f;
    return std::tuple(std::lround(p.x), std::lround(p.y), std::lround(p.z));
  };
  std::map<std::pair<decltype(key(0)), decltype(key(0))>, int> edges;
  double volume = 0;
  for (const glm::uvec3& t : barrel.triangles) {
    if (key(t.x) == key(t.y) || key(t.y) == key(t.z) || key(t.z) == key(t.x)) {
      continue;  // at the middle of a head
    }
    for (int corner = 0; corner < 3; ++corner) {
      ++edges[{key(t[corner]), key(t[(corner + 1) % 3])}];
    }
    volume += static_cast<double>(
        glm::dot(barrel.positions[t.x], glm::cross(barrel.positions[t.y], barrel.positions[t.z])) / 6);
  }
  for (const auto& [edge, count] : edges) {
    const auto other = edges.find({edge.second, edge.first});
    ASSERT_NE(other, edges.end());
    EXPECT_EQ(count, other->second);
  }
  // Between a cylinder of its least radius and one of its greatest.
  EXPECT_GT(volume, 3.14 * 0.28 * 0.28 * 0.82);
  EXPECT_LT(volume, 3.15 * 0.355 * 0.355 * 0.9);
}

TEST(ParkedThings, manyStandInScenes) {
  for (const auto& [source, count] : {std::pair("builtin:parking", 40u), std::pair("builtin:barrels", 60u),
                                      std::pair("builtin:parking,tiles=7", 7u)}) {
    const Scene scene = makeBuiltinScene(source);
    size_t tiles = 0;
    std::set<size_t> meshes;
    for (const Instance& instance : scene.instances) {
      if (instance.object == 1) {
        ++tiles;
        meshes.insert(instance.mesh);
      }
    }
    EXPECT_EQ(tiles, count) << source;
    EXPECT_EQ(meshes.size(), 1u) << source;
    size_t relief = 0;
    for (const RoledObject& role : builtinRoles(source)) {
      relief += role.object == 1 && role.has(kIsRelief);
    }
    EXPECT_EQ(relief, 1u);
  }
}

}  // namespace
}  // namespace ocelli
