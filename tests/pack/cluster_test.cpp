#include "oc_core/pack/cluster.h"

#include <gtest/gtest.h>

#include "oc_core/pack/cluster_groups.h"
#include "tests/pack/packed_meshes.h"

namespace ocelli {
namespace {

using test::looseGrid;
using test::weldedOf;

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

}  // namespace
}  // namespace ocelli
