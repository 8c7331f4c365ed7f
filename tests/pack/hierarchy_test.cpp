#include "oc_core/pack/hierarchy.h"

#include <gtest/gtest.h>

#include "oc_core/pack/pack_scene.h"
#include "tests/base/temporary_folder.h"
#include "tests/pack/packed_meshes.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;

bool contains(const Sphere& outer, const Sphere& inner) {
  return glm::distance(outer.center, inner.center) + inner.radius <= outer.radius * (1 + 1e-5f);
}

TEST(Hierarchy, NeitherSpheresNorErrorsShrinkFromALevelToTheNext) {
  const TemporaryFolder folder;
  const PackedScene scene = test::packed(test::bumpyBall(60'000), folder / "ball.opack");
  size_t replaced = 0;
  for (uint32_t g = 0; g < scene.groupCount(); ++g) {
    const PackedGroupInfo group = scene.group(g);
    for (uint32_t inner = 0; inner < group.innerGroups; ++inner) {
      EXPECT_TRUE(contains(group.sphere, scene.group(group.firstInner + inner).sphere));
    }
    for (uint32_t i = 0; i < group.clusters; ++i) {
      const PackedClusterInfo cluster = scene.cluster(g, i);
      EXPECT_TRUE(contains(group.sphere, cluster.bounds));
      if (cluster.finer != PackedClusterInfo::kNone) {
        const PackedGroupInfo finer = scene.group(cluster.finer);
        EXPECT_TRUE(contains(group.sphere, finer.sphere));
        EXPECT_LE(finer.error, group.error);
        ++replaced;
      }
    }
  }
  EXPECT_GT(replaced, 100U);
}

TEST(Hierarchy, BecomesAFewClusters) {
  const TemporaryFolder folder;
  const PackedScene scene = test::packed(test::bumpyBall(60'000), folder / "ball.opack");
  const std::vector<ClusterChoice> coarsest = chooseClusters(
      scene, [](const Sphere&) { return true; }, [](const Sphere&, float) { return true; });
  EXPECT_LE(coarsest.size(), 24U);
}

/// What is drawn fine on one side and coarse on the other still fits.
TEST(Hierarchy, CutsOfAClosedSurfaceAreClosed) {
  const TemporaryFolder folder;
  const Mesh ball = test::bumpyBall(60'000);
  ASSERT_EQ(test::openEdges(ball), 0U);
  const PackedScene scene = test::packed(ball, folder / "ball.opack");
  std::vector<size_t> sizes;
  for (const float finest : {1e-5f, 1e-4f, 1e-3f, 1e-2f}) {
    // Finer towards one side.
    const std::vector<ClusterChoice> cut = chooseClusters(
        scene, [](const Sphere&) { return true; },
        [&](const Sphere& sphere, float error) {
          const float distance = std::max(0.0f, glm::distance(sphere.center, glm::vec3(0.9f, 0, 0)) - sphere.radius);
          return error <= finest * (0.1f + 5 * distance);
        });
    const Mesh mesh = meshOf(scene, cut);
    EXPECT_EQ(test::openEdges(mesh), 0U) << "error " << finest;
    sizes.push_back(mesh.triangles.size());
  }
  EXPECT_TRUE(std::is_sorted(sizes.rbegin(), sizes.rend()));
  // Groups whose spheres hold the near side stay fine: it is a small surface.
  EXPECT_LT(sizes.back(), sizes.front() / 2);
}

/// Each triangle with a colour of its own, so that no vertex is shared.
Mesh patchwork(size_t triangles) {
  const Mesh ball = test::bumpyBall(triangles);
  Mesh mesh;
  for (size_t i = 0; i < ball.triangles.size(); ++i) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (glm::length_t k = 0; k < 3; ++k) {
      mesh.positions.push_back(ball.positions[ball.triangles[i][k]]);
      mesh.colors.push_back(glm::vec3(0.4f + 0.2f * static_cast<float>(i % 3)));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(Hierarchy, WhatColorsSplitIsSimplifiedToo) {
  const TemporaryFolder folder;
  const PackedScene scene = test::packed(patchwork(20'000), folder / "patches.opack");
  const std::vector<ClusterChoice> coarsest = coarsestClusters(scene, 1e9f);
  EXPECT_LE(coarsest.size(), 24U);
  for (const float maxError : {1e-3f, 1e-2f, 1e9f}) {
    EXPECT_EQ(test::openEdges(meshOf(scene, coarsestClusters(scene, maxError))), 0U) << maxError;
  }
  // Colours of neighbours differ by 0.2 of full light from their mean, over triangles that are some 0.02 high.
  EXPECT_EQ(meshOf(scene, coarsestClusters(scene, 1e-5f)).triangles.size(), patchwork(20'000).triangles.size());
}

/// Brute force: a vertex of the scene is no farther from the cut than the error says.
TEST(Hierarchy, ErrorsBoundTheDistanceOfVertices) {
  const TemporaryFolder folder;
  const Mesh ball = test::bumpyBall(20'000);
  const PackedScene scene = test::packed(ball, folder / "ball.opack");
  for (const float error : {1e-3f, 4e-3f, 1e-2f}) {
    const Mesh mesh = meshOf(
        scene, chooseClusters(
                   scene, [](const Sphere&) { return true; }, [&](const Sphere&, float e) { return e <= error; }));
    float worst = 0;
    for (size_t i = 0; i < ball.positions.size(); i += 23) {
      const glm::vec3& p = ball.positions[i];
      float nearest = 1e30f;
      for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3& a = mesh.positions[t.x];
        const glm::vec3& b = mesh.positions[t.y];
        const glm::vec3& c = mesh.positions[t.z];
        if (glm::distance(p, a) > nearest + glm::distance(a, b) + glm::distance(a, c)) {
          continue;
        }
        // The distance along a dense lattice of the triangle: never less than the true one.
        constexpr int kSteps = 12;
        for (int k = 0; k <= kSteps; ++k) {
          for (int l = 0; k + l <= kSteps; ++l) {
            const glm::vec3 q =
                a + (b - a) * (static_cast<float>(k) / kSteps) + (c - a) * (static_cast<float>(l) / kSteps);
            nearest = std::min(nearest, glm::distance(p, q));
          }
        }
      }
      worst = std::max(worst, nearest);
    }
    float longest = 0;
    for (const glm::uvec3& t : mesh.triangles) {
      longest = std::max(longest, glm::distance(mesh.positions[t.x], mesh.positions[t.y]));
    }
    // The lattice misses the nearest point by a part of a side at most; hypot, as it is off along the surface.
    EXPECT_LE(worst, std::hypot(error, longest / 12)) << error;
  }
}

}  // namespace
}  // namespace ocelli
