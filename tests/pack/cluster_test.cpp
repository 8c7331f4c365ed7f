#include "oc_core/pack/cluster.h"

#include <gtest/gtest.h>

#include "oc_core/pack/cluster_groups.h"
#include "oc_core/pack/simplify_group.h"
#include "tests/pack/packed_meshes.h"

namespace ocelli {
namespace {

WeldedTriangles weldedOf(const Mesh& mesh) {
  Welder welder(mesh.positions.size());
  for (const glm::uvec3& t : mesh.triangles) {
    std::array<uint32_t, 3> corners{};
    for (glm::length_t k = 0; k < 3; ++k) {
      corners[static_cast<size_t>(k)] = welder.vertex(mesh.positions[t[k]], packedColor(mesh.color(t[k])));
    }
    welder.add(corners[0], corners[1], corners[2]);
  }
  return welder.take();
}

/// The grid of a plane, (n + 1)^2 vertices, with a vertex of its own for each corner of each triangle.
Mesh looseGrid(int n) {
  Mesh mesh;
  const auto corner = [&](int x, int y) {
    mesh.positions.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0f);
    return static_cast<uint32_t>(mesh.positions.size() - 1);
  };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const uint32_t a = corner(x, y);
      const uint32_t b = corner(x + 1, y);
      const uint32_t c = corner(x + 1, y + 1);
      mesh.triangles.emplace_back(a, b, c);
      const uint32_t d = corner(x, y);
      const uint32_t e = corner(x + 1, y + 1);
      const uint32_t f = corner(x, y + 1);
      mesh.triangles.emplace_back(d, e, f);
    }
  }
  return mesh;
}

TEST(Welder, EqualVerticesAreOne) {
  const WeldedTriangles welded = weldedOf(looseGrid(40));
  EXPECT_EQ(welded.positions.size(), 41U * 41U);
  EXPECT_EQ(welded.triangleCount(), 3200U);
}

TEST(Welder, NegativeZeroIsZero) {
  Welder welder(1);
  EXPECT_EQ(welder.vertex({0.0f, 1, 2}, {}), welder.vertex({-0.0f, 1, 2}, {}));
}

TEST(Welder, OtherColorsAreOtherVertices) {
  Welder welder(1);
  EXPECT_NE(welder.vertex({0, 1, 2}, {1, 2, 3}), welder.vertex({0, 1, 2}, {1, 2, 4}));
}

TEST(Welder, DropsTrianglesWithoutArea) {
  Welder welder(4);
  const uint32_t a = welder.vertex({0, 0, 0}, {});
  const uint32_t b = welder.vertex({1, 0, 0}, {});
  welder.add(a, b, a);
  EXPECT_EQ(welder.take().triangleCount(), 0U);
}

TEST(PackedColor, GoesThereAndBackWithinHalfAStep) {
  for (int i = 0; i <= 1000; ++i) {
    const float light = static_cast<float>(i) / 1000;
    EXPECT_NEAR(linearColor(packedColor(glm::vec3(light))).g, light, 0.5f / 65535 + 1e-7f);
  }
  EXPECT_EQ(packedColor({-1, 2, 1}), (PackedColor{0, 65535, 65535}));
}

TEST(Clusters, HoldEachTriangleOnceAndKeepTheirBounds) {
  const Mesh ball = test::bumpyBall(20'000);
  Mesh again;
  size_t most = 0;
  for (const Cluster& cluster : clustersOf(weldedOf(ball))) {
    EXPECT_LE(cluster.positions.size(), Cluster::kMaxVertices);
    EXPECT_LE(cluster.triangles.size(), Cluster::kMaxTriangles);
    most = std::max(most, cluster.triangles.size());
    const auto first = static_cast<uint32_t>(again.positions.size());
    again.positions.insert(again.positions.end(), cluster.positions.begin(), cluster.positions.end());
    for (const auto& [a, b, c] : cluster.triangles) {
      again.triangles.emplace_back(first + a, first + b, first + c);
    }
  }
  EXPECT_EQ(test::trianglesOf(again), test::trianglesOf(ball));
  EXPECT_GE(most, 100U);
}

TEST(ClusterGroups, HoldEachClusterOnceWithinTheirSize) {
  const std::vector<Cluster> clusters = clustersOf(weldedOf(test::bumpyBall(40'000)));
  std::vector<const Cluster*> pointers;
  for (const Cluster& cluster : clusters) {
    pointers.push_back(&cluster);
  }
  std::vector<int> seen(clusters.size(), 0);
  for (const std::vector<uint32_t>& group : groupsOf(pointers)) {
    EXPECT_LE(group.size(), kMaxClustersOfGroup);
    for (const uint32_t cluster : group) {
      ++seen[cluster];
    }
  }
  EXPECT_EQ(seen, std::vector<int>(clusters.size(), 1));
}

TEST(SimplifyGroup, APlaneLosesTrianglesWithoutErrorAndKeepsItsBorder) {
  const WeldedTriangles plane = weldedOf(looseGrid(24));
  const std::optional<SimplifiedTriangles> coarse = simplified(plane);
  ASSERT_TRUE(coarse);
  EXPECT_LT(coarse->triangles.triangleCount(), plane.triangleCount() * 6 / 10);
  EXPECT_NEAR(coarse->error.distance, 0, 1e-5f);
  EXPECT_EQ(coarse->error.color, 0);
  size_t border = 0;
  for (const glm::vec3& p : coarse->triangles.positions) {
    border += p.x == 0 || p.y == 0 || p.x == 24 || p.y == 24 ? 1 : 0;
  }
  EXPECT_EQ(border, 4U * 24U);
}

TEST(SimplifyGroup, AColorThatIsLostIsAnError) {
  WeldedTriangles plane = weldedOf(looseGrid(24));
  for (size_t i = 0; i < plane.positions.size(); ++i) {
    plane.colors[i] = packedColor(glm::vec3(i % 2 == 0 ? 1.0f : 0.25f));
  }
  const std::optional<SimplifiedTriangles> coarse = simplified(plane);
  ASSERT_TRUE(coarse);
  // Some vertex with 0.25 lies on a triangle of full light, or the other way round; no side is shorter than 1.
  EXPECT_GT(coarse->error.color, 0.75f / 3);
}

TEST(SimplifyGroup, TrianglesWithoutNeighborsStay) {
  Mesh loose;
  for (int i = 0; i < 300; ++i) {
    const auto x = static_cast<float>(i);
    loose.positions.insert(loose.positions.end(), {{x, 0, 0}, {x + 0.5f, 0, 0}, {x, 0.5f, 0}});
    const auto first = static_cast<uint32_t>(3 * i);
    loose.triangles.emplace_back(first, first + 1, first + 2);
  }
  EXPECT_FALSE(simplified(weldedOf(loose)));
}

}  // namespace
}  // namespace ocelli
