#include "oc_core/render/rasterize_graph.h"

#include <gtest/gtest.h>

#include <functional>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/scene_renderer.h"
#include "oc_core/scene/densify.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/solids.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/render/ray_agreement.h"
#include "tests/render/render_checks.h"

namespace ocelli {
namespace {

using test::coveredPixels;
using test::crossroads;
using test::Disagreement;
using test::disagreement;
using test::smallCamera;
using test::turnAt;

GraphCamera mergedBehind(const PinholeCamera& camera) {
  GraphCamera graph(camera);
  const auto [left, right] = graph.split(0, turnAt({0, 0, 0.4}, {-0.2, 0, -1}, {0.8, 0, 8}),
                                         turnAt({0, 0, 0.4}, {0.2, 0, -1}, {-0.8, 0, 8}), "left", "right");
  graph.merge(left, right, turnAt({0, 0, -0.3}, {0, 0, -1}, {0, 0, 6}), "behind");
  return graph;
}

/// Frusta that end at walls: before the objects, among them, and behind.
GraphCamera limited(const PinholeCamera& camera) {
  GraphCamera graph = crossroads(camera);
  graph.limit(1, Plane::through({0, 0, -0.4}, {0.1, 0, -1}));
  graph.limit(2, Plane::through({0, 0, -0.2}, {0, 0.2, -1}));
  graph.limit(2, Plane::through({1, 0, 0}, {1, 0, -0.3}));
  graph.limit(3, Plane::through({0, 0, -4}, {0, 0, -1}));
  return graph;
}

/// Rays through a part of the image bend, to run closer together; those around it run on to a limit.
GraphCamera withADoor(const PinholeCamera& camera) {
  GraphCamera graph(camera);
  const double w = camera.width();
  const double h = camera.height();
  graph.bend(0, turnAt({0, 0, 0.2}, {0.2, 0, -1}, {0.3, 0.1, 40}), "door",
             {{0.3 * w, 0.25 * h}, {0.7 * w, 0.3 * h}, {0.65 * w, 0.8 * h}});
  graph.limit(0, Plane::through({0, 0, -0.1}, {0, 0, -1}));
  return graph;
}

TEST(RasterizeGraph, theRootAloneIsThePinhole) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const PinholeCamera camera(View{}, 180, 120);
  const Disagreement d = disagreement(rasterize(camera, mesh), rasterize(GraphCamera(camera), mesh), 1e-4f);
  EXPECT_LE(d.differing, d.samples / 1000) << d;
}

// At silhouettes rounding decides, and where planes or parts pass through a pixel centre. Images are of a width at
// which no bar of the fence ends along a column of pixel centres.
TEST(RasterizeGraph, agreesWithRayCasting) {
  const PinholeCamera camera(View{}, 196, 130);
  for (const char* scene : {"builtin:boxes", "builtin:statues", "builtin:fence,gap=4"}) {
    const Mesh mesh = loadScene(scene, {}, {});
    const RayScene rays(mesh);
    for (const GraphCamera& graph : {crossroads(camera), mergedBehind(camera), limited(camera), withADoor(camera)}) {
      const Disagreement d = disagreement(raycast(graph, mesh, rays), rasterize(graph, mesh), 1e-4f);
      EXPECT_GT(d.samples, 2000u);
      EXPECT_LE(d.differing, d.samples / 200) << scene << ": " << d;
      EXPECT_LE(d.apart, d.samples / 5000) << scene << ": " << d;
    }
  }
}

// What is seen is the same without depths, where all of the scene ends before zFar.
TEST(RasterizeGraph, samplesAreThoseOfTheImage) {
  const PinholeCamera camera(View{}, 196, 130);
  const Mesh mesh = loadScene("builtin:statues", {}, {});
  const MeshBlocks blocks(mesh);
  for (const GraphCamera& graph :
       {GraphCamera(camera), crossroads(camera), mergedBehind(camera), limited(camera), withADoor(camera)}) {
    ASSERT_TRUE(endsBeforeZFar(graph, boundsOf(mesh)));
    FragmentImage expected = rasterize(graph, mesh, blocks);
    for (size_t i = 0; i < expected.size(); ++i) {
      expected[i].t = 0;
    }
    FragmentImage samples(camera.width(), camera.height());
    visitSamples(graph, mesh, blocks, [&](const RegionBuffer::SampleRun& run) {
      for (size_t i = 0; i < run.size; ++i) {
        samples[samples.index(run.x, run.y) + i] = run.fragment(i);
        samples[samples.index(run.x, run.y) + i].t = 0;
      }
    });
    EXPECT_TRUE(std::equal(samples.begin(), samples.end(), expected.begin()));
    EXPECT_GT(coveredPixels(samples), 1000u);
  }
}

// No z of a sample is as large as what is said to be enough for all.
TEST(RasterizeGraph, knowsWhetherAllEndsBeforeZFar) {
  Mesh mesh = loadScene("builtin:statues", {}, {});
  append(mesh, makeBox({60, 60, 1}), glm::translate(glm::mat4(1), glm::vec3(0, 0, -40)));
  const PinholeCamera far(View{}, 98, 65);
  int beyond = 0;
  const auto pinhole = [](const PinholeCamera& camera) { return GraphCamera(camera); };
  for (const auto& make : std::initializer_list<std::function<GraphCamera(const PinholeCamera&)>>{
           pinhole, [](const PinholeCamera& camera) { return crossroads(camera); }, mergedBehind, limited, withADoor}) {
    float farthest = 0;
    for (const Fragment& fragment : rasterize(make(far), mesh)) {
      farthest = std::max(farthest, fragment.t);
    }
    View view;
    view.zFar = 12;  // beyond all turns, and before the wall
    beyond += farthest > 2 * view.zFar ? 1 : 0;
    while (!endsBeforeZFar(make(PinholeCamera(view, 98, 65)), boundsOf(mesh))) {
      view.zFar *= 1.02f;
    }
    EXPECT_GT(view.zFar, farthest);
    EXPECT_LT(view.zFar, 20 * farthest) << "a bound that lets nothing through is of no use";
  }
  EXPECT_EQ(beyond, 3) << "rays of the last two end before the wall, or see it hidden";
  View view;
  view.zFar = glm::length(view.eye);
  EXPECT_FALSE(endsBeforeZFar(pinhole(PinholeCamera(view, 98, 65)), boundsOf(mesh)));
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

// A wall just at a limit is seen, one behind it is not.
TEST(RasterizeGraph, limitsKeepTheWallThatTheyStandFor) {
  const PinholeCamera camera(View{}, 90, 60);
  for (const float z : {-0.2f, -0.3f}) {
    Mesh mesh;
    test::addWall(mesh, z, 3);
    GraphCamera graph(camera);
    graph.limit(0, Plane::through({0, 0, static_cast<double>(-0.2f)}, {0, 0, -1}));
    EXPECT_EQ(coveredPixels(rasterize(graph, mesh)), z == -0.2f ? 90u * 60 : 0u);
  }
}

// Closed around all that the rays pass: no pixel may see through a crack between triangles or planes.
TEST(RasterizeGraph, wallsAllAroundLeaveNoCrack) {
  const PinholeCamera camera(View{}, 180, 120);
  Mesh box;
  append(box, makeBox({3.5f, 2.6f, 20}), glm::translate(glm::mat4(1), glm::vec3(0.2f, 0.1f, -8)));
  for (const size_t triangles : {12, 5000}) {
    for (int turned = 0; turned < 4; ++turned) {
      Mesh mesh;
      append(mesh, box, glm::rotate(glm::mat4(1), 0.05f * static_cast<float>(turned), glm::vec3(0.2f, 0.6f, 0.7f)));
      densify(mesh, triangles);
      EXPECT_EQ(coveredPixels(rasterize(crossroads(camera), mesh)), 180u * 120) << triangles << ", " << turned;
      EXPECT_EQ(coveredPixels(rasterize(mergedBehind(camera), mesh)), 180u * 120) << triangles << ", " << turned;
    }
  }
}

TEST(RasterizeGraph, whatDrawsScenesByRaysDrawsGraphAndCurvedRayCameras) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const RayScene rays(mesh);
  const RayRenderer renderer(mesh, rays);
  const SceneRenderer& any = renderer;
  EXPECT_EQ(any.draw(crossroads()), raycast(crossroads(), mesh, rays));
  EXPECT_EQ(any.draw(test::bendingTwice()), raycast(test::bendingTwice(), mesh, rays));
}

TEST(RasterizeGraph, preparedBlocksDrawTheSame) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const GraphCamera graph = crossroads(PinholeCamera(View{}, 180, 120));
  EXPECT_EQ(rasterize(graph, mesh, MeshBlocks(mesh)), rasterize(graph, mesh));
  EXPECT_EQ(rasterize(graph, mesh, MeshBlocks(mesh, MeshBlocks::Order::kInSpace)), rasterize(graph, mesh));
}

// Sizes from nothing to the largest numbers: what is drawn is a sample of the triangle.
TEST(RasterizeGraph, enduresAnySize) {
  const GraphCamera graph = crossroads();
  for (const float size : {1e-30f, 1e-6f, 1e6f, 1e20f, 3e38f}) {
    const Mesh mesh{{{-size, -size, 0}, {size, -size, -1}, {0, size, 1}, {0, size, -size}}, {}, {{0, 1, 2}, {0, 1, 3}}};
    for (const Fragment& f : rasterize(graph, mesh)) {
      EXPECT_TRUE(!f.covered() || (f.t > 0 && std::isfinite(f.b1) && std::isfinite(f.b2)));
    }
  }
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
  EXPECT_EQ(coveredPixels(rasterize(graph, Mesh{})), 0u);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Mesh broken{{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, {}, {{0, 1, 2}, {0, 0, 0}}};
  EXPECT_EQ(coveredPixels(rasterize(graph, broken)), 0u);
}

TEST(RasterizeGraph, brokenTrianglesLeaveTheirNeighboursAlone) {
  const GraphCamera graph = crossroads();
  Mesh mesh = loadScene("builtin:boxes", {}, {});
  const FragmentImage whole = rasterize(graph, mesh);
  test::addBrokenTriangles(mesh);
  EXPECT_EQ(whole, rasterize(graph, mesh));
}

}  // namespace
}  // namespace ocelli
