#include "oc_core/depth_rays/sample_pyramid.h"

#include <gtest/gtest.h>

#include "oc_core/depth_rays/depth_image_target.h"
#include "tests/depth_rays/sampled_scenes.h"

namespace ocelli {
namespace {

/// Children that wait at once where all are met, in whatever order; and how many are met.
struct FullWalk {
  size_t waiting = 0;
  size_t steps = 0;
};

FullWalk walkAll(const SamplePyramid& pyramid) {
  FullWalk walk;
  std::vector<uint32_t> waiting;
  if (const auto root = pyramid.root()) {
    waiting.push_back(*root);
  }
  while (!waiting.empty()) {
    walk.waiting = std::max(walk.waiting, waiting.size());
    const uint32_t reference = waiting.back();
    waiting.pop_back();
    ++walk.steps;
    if ((reference & SamplePyramid::kCellBit) == 0) {
      const SamplePyramid::Node& node = pyramid.nodes()[reference];
      waiting.insert(waiting.end(), node.child.begin(), node.child.begin() + node.count);
    }
  }
  return walk;
}

// What walks on a GPU has room for that many, and no more.
TEST(SamplePyramid, noMoreChildrenWaitThanItsDepthAllows) {
  const Mesh mesh = test::thingsBeforeWall();
  for (const int width : {1, 3, 12, 90, 480}) {
    const DepthImageTarget target({buildDepthImage(PinholeCamera({}, width, (width * 2 + 2) / 3), mesh)});
    const FullWalk walk = walkAll(target.pyramid());
    EXPECT_LE(walk.waiting, target.pyramid().maxWaiting()) << width;
    // Nodes have 8 children or more but for the lowest ones and the root.
    EXPECT_GE(2 * walk.waiting, target.pyramid().maxWaiting() / 2) << width;
    EXPECT_EQ(walk.steps, target.maxSteps()) << width << ": each is met once";
  }
}

TEST(SamplePyramid, isAsDeepAsItsNodesStand) {
  Mesh mesh;
  const auto pyramidOf = [&](uint32_t triangles) {
    mesh = {};
    for (uint32_t i = 0; i < triangles; ++i) {
      const auto x = static_cast<float>(i);
      mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
      mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    const SampleCells cells = triangleCells(mesh);
    const SamplePyramid pyramid(cells);
    return std::pair(pyramid.depth(), pyramid.maxWaiting());
  };
  EXPECT_EQ(pyramidOf(0), std::pair(size_t{0}, size_t{1}));
  EXPECT_EQ(pyramidOf(1), std::pair(size_t{0}, size_t{1})) << "a cell alone";
  EXPECT_EQ(pyramidOf(2), std::pair(size_t{1}, size_t{16}));
  EXPECT_EQ(pyramidOf(16), std::pair(size_t{1}, size_t{16}));
  EXPECT_EQ(pyramidOf(17), std::pair(size_t{2}, size_t{31}));
  EXPECT_EQ(pyramidOf(256), std::pair(size_t{2}, size_t{31}));
  EXPECT_EQ(pyramidOf(272), std::pair(size_t{3}, size_t{46}));
}

TEST(SampleCells, ofAMeshAreItsTriangles) {
  const Mesh mesh = test::thingsBeforeWall();
  const SampleCells cells = triangleCells(mesh);
  EXPECT_EQ(cells.mesh.triangles, mesh.triangles);
  EXPECT_GE(cells.cellCount(), mesh.triangles.size());
  EXPECT_LT(cells.cellCount(), mesh.triangles.size() + 4);
  for (size_t i = 0; i < cells.cellCount(); ++i) {
    EXPECT_EQ(cells.firstTriangle[i], std::min(i, mesh.triangles.size()));
  }
  const SamplePyramid pyramid(cells);
  Random random(6);
  size_t met = 0;
  for (int i = 0; i < 500; ++i) {
    const RayPath path = test::randomRay(random);
    const StraightRay ray{path[0], path[1] - path[0], 1};
    RayCost cost;
    const auto fast = pyramid.meet(ray, cost);
    const auto slow = meetEveryCell(cells, ray);
    ASSERT_EQ(fast.has_value(), slow.has_value());
    met += slow.has_value();
    ASSERT_TRUE(!slow || fast->triangle == slow->triangle);
  }
  EXPECT_GT(met, 100u);
}

}  // namespace
}  // namespace ocelli
