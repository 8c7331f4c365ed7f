#include "oc_core/worlds/canyon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

TEST(CanyonPath, RunsUpstreamFromEdgeToEdge) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    const std::vector<glm::vec3> path = canyonPath(seed);
    EXPECT_EQ(path.front().z, kCanyonHalfSize);
    EXPECT_EQ(path.back().z, -kCanyonHalfSize);
    size_t turns = 0;
    for (size_t i = 1; i < path.size(); ++i) {
      EXPECT_LT(path[i].z, path[i - 1].z);
      EXPECT_GT(path[i].y, path[i - 1].y);
      EXPECT_LT(std::abs(path[i].x), 200.0f);
      const bool turnsBack = i + 1 < path.size() && (path[i].x - path[i - 1].x) * (path[i + 1].x - path[i].x) < 0;
      turns += turnsBack ? 1 : 0;
    }
    EXPECT_GE(turns, 3u) << "it winds";
  }
}

TEST(Canyon, IsAClosedSolid) {
  for (const size_t cells : {8u, 33u, 100u}) {
    const Mesh mesh = makeCanyon({4, cells}, canyonPath(4));
    EXPECT_TRUE(isClosed(mesh)) << cells;
    // A block of 1000 m with a bottom at -40 m and a plateau at about 150 m, less a canyon of less than half its width.
    EXPECT_GT(signedVolume(mesh), 1e6 * 100) << cells;
    EXPECT_LT(signedVolume(mesh), 1e6 * 206) << cells;
    EXPECT_EQ(mesh.triangles.size(), 2 * cells * cells + 4 * cells * (2 * 12 + 1)) << cells;
    const Box box = boundsOf(mesh);
    EXPECT_EQ(box.lower.x, -kCanyonHalfSize);
    EXPECT_EQ(box.upper.x, kCanyonHalfSize);
  }
}

TEST(Canyon, HasItsRiverWhereThePathSays) {
  const std::vector<glm::vec3> path = canyonPath(3);
  const size_t cells = 256;
  const Mesh mesh = makeCanyon({3, cells}, path);
  size_t inRiver = 0;
  for (size_t v = 0; v < (cells + 1) * (cells + 1); ++v) {
    const glm::vec3& point = mesh.positions[v];
    float distance = std::numeric_limits<float>::max();
    float water = 0;
    for (const glm::vec3& on : path) {
      const float d = std::hypot(point.x - on.x, point.z - on.z);
      if (d < distance) {
        distance = d;
        water = on.y;
      }
    }
    if (distance < kRiverHalfWidth - 6) {  // points of the path are up to 2 * 5.5 m apart
      ++inRiver;
      EXPECT_NEAR(point.y, water, 0.5f);  // it falls 14 m in 1000 m
    } else if (distance > kRiverHalfWidth + 200) {
      EXPECT_GT(point.y, 100.0f) << "the plateau";
    }
  }
  EXPECT_GT(inRiver, 500u);
}

TEST(Canyon, ComesNearAnyNumberOfTriangles) {
  EXPECT_EQ(canyonTriangles(33), makeCanyon({4, 33}, canyonPath(4)).triangles.size());
  for (const size_t triangles : {1u, 900u, 120'000u, 500'000u, 2'000'000u, 8'593'408u}) {
    const size_t cells = canyonCells(triangles);
    const auto off = [&](size_t c) {
      return std::abs(static_cast<double>(canyonTriangles(c)) - static_cast<double>(triangles));
    };
    EXPECT_LE(off(cells), off(cells + 1)) << triangles;
    EXPECT_TRUE(cells == 8 || off(cells) <= off(cells - 1)) << triangles;
    EXPECT_LE(cells, 2048u);
  }
  EXPECT_EQ(triangleCount(makeBuiltinScene("builtin:canyon,triangles=120000")), canyonTriangles(canyonCells(120'000)));
}

TEST(BuiltinCanyon, ComesWithItsPathInTheWorld) {
  const GuidedScene canyon = loadGuidedScene("builtin:canyon,seed=3,cells=32");
  ASSERT_EQ(canyon.guides.path.size(), canyonPath(3).size());
  for (size_t i = 0; i < canyon.guides.path.size(); ++i) {
    const glm::vec3 expected(canyon.worldFromScene * glm::vec4(canyonPath(3)[i], 1));
    EXPECT_EQ(canyon.guides.path[i], expected);
    EXPECT_LT(glm::length(expected), 1.0f);
  }
  const GuidedScene again = loadGuidedScene("builtin:canyon,seed=3,cells=32");
  EXPECT_EQ(canyon.mesh.positions, again.mesh.positions);
  EXPECT_EQ(canyon.mesh.colors, again.mesh.colors);
  EXPECT_NE(canyon.mesh.positions, loadGuidedScene("builtin:canyon,seed=4,cells=32").mesh.positions);
}

}  // namespace
}  // namespace ocelli
