#include "oc_core/render/rasterize_graph.h"

#include <gtest/gtest.h>

#include "oc_core/base/parallel.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/raycast.h"
#include "oc_core/scene/scene_source.h"
#include "tests/camera/test_graph_cameras.h"

namespace ocelli {
namespace {

using test::crossroads;
using test::smallCamera;
using test::turnAt;

/// Pixels that two images differ at: in what covers them, or by more than 1e-4 of the depth.
size_t differing(const FragmentImage& a, const FragmentImage& b) {
  size_t count = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    count += a[i].covered() != b[i].covered() || std::abs(a[i].z - b[i].z) > 1e-4f * a[i].z;
  }
  return count;
}

size_t covered(const FragmentImage& image) {
  return static_cast<size_t>(std::count_if(image.begin(), image.end(), [](const Fragment& f) { return f.covered(); }));
}

GraphCamera mergedBehind(const PinholeCamera& camera) {
  GraphCamera graph(camera);
  const auto [left, right] = graph.split(0, turnAt({0, 0, 0.4}, {-0.2, 0, -1}, {0.8, 0, 8}),
                                         turnAt({0, 0, 0.4}, {0.2, 0, -1}, {-0.8, 0, 8}), "left", "right");
  graph.merge(left, right, turnAt({0, 0, -0.3}, {0, 0, -1}, {0, 0, 6}), "behind");
  return graph;
}

TEST(RasterizeGraph, theRootAloneIsThePinhole) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const PinholeCamera camera(View{}, 180, 120);
  const FragmentImage expected = rasterize(camera, mesh);
  EXPECT_LE(differing(expected, rasterize(GraphCamera(camera), mesh)), covered(expected) / 1000);
}

// At silhouettes rounding decides, and where planes or parts pass through a pixel centre.
TEST(RasterizeGraph, agreesWithRayCasting) {
  const PinholeCamera camera(View{}, 180, 120);
  for (const char* scene : {"builtin:boxes", "builtin:statues", "builtin:fence,gap=4"}) {
    const Mesh mesh = loadScene(scene, {}, {});
    const RayScene rays(mesh);
    for (const GraphCamera& graph : {crossroads(camera), mergedBehind(camera)}) {
      const FragmentImage cast = raycast(graph, mesh, rays);
      const size_t seen = covered(cast);
      EXPECT_GT(seen, 2000u);
      EXPECT_LE(differing(cast, rasterize(graph, mesh)), seen / 200) << scene;
    }
  }
}

TEST(RasterizeGraph, seesBehindAnObject) {
  // A wall before a smaller one, which the pinhole does not see.
  Mesh mesh;
  test::addWall(mesh, 0, 0.3f);
  const size_t front = mesh.triangles.size();
  test::addWall(mesh, -2, 0.25f);
  const auto seesBehind = [&](const FragmentImage& image) {
    return std::any_of(image.begin(), image.end(),
                       [&](const Fragment& f) { return f.covered() && f.triangle >= front; });
  };
  const PinholeCamera camera(View{}, 180, 120);
  EXPECT_FALSE(seesBehind(rasterize(camera, mesh)));
  GraphCamera graph(camera);
  graph.bend(0, turnAt({0, 0, -0.5}, {0, 0, -1}, {0, 4, 5}), "over it");
  EXPECT_TRUE(seesBehind(rasterize(graph, mesh)));
}

TEST(RasterizeGraph, sameBytesForAnyNumberOfThreads) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const GraphCamera graph = crossroads(PinholeCamera(View{}, 180, 120));
  setThreadCount(1);
  const FragmentImage one = rasterize(graph, mesh);
  setThreadCount(5);
  EXPECT_EQ(one, rasterize(graph, mesh));
  setThreadCount(0);
}

TEST(RasterizeGraph, drawsNothingOfWhatIsNot) {
  const GraphCamera graph = crossroads();
  EXPECT_EQ(covered(rasterize(graph, Mesh{})), 0u);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Mesh broken{{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, {}, {{0, 1, 2}, {0, 0, 0}}};
  EXPECT_EQ(covered(rasterize(graph, broken)), 0u);
}

TEST(RasterizeGraph, brokenTrianglesLeaveTheirNeighboursAlone) {
  const GraphCamera graph = crossroads();
  Mesh mesh = loadScene("builtin:boxes", {}, {});
  const FragmentImage whole = rasterize(graph, mesh);
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  mesh.positions.insert(mesh.positions.end(), {{nan, 0, 0}, {infinite, 1, 0}, {0, 0, -infinite}});
  mesh.colors.resize(mesh.positions.size(), glm::vec3(1));
  mesh.triangles.push_back({first, 0, 1});
  mesh.triangles.push_back({0, first + 1, 1});
  mesh.triangles.push_back({0, 1, first + 2});
  EXPECT_EQ(whole, rasterize(graph, mesh));
}

}  // namespace
}  // namespace ocelli
