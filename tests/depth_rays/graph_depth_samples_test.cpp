#include "oc_core/depth_rays/graph_depth_samples.h"

#include <gtest/gtest.h>

#include "oc_core/render/rasterize_graph.h"
#include "oc_core/render/raycast.h"
#include "tests/render/crossing_corridors.h"

namespace ocelli {
namespace {

using Sample = GraphDepthSamples::Sample;
using test::smallCamera;
using test::turnAt;

/// Turns to the right by 180 degrees, in three bends: rays come back beside their beginning.
GraphCamera turningBack() {
  View view;
  view.fovVerticalDegrees = 4;
  GraphCamera graph(PinholeCamera(view, 90, 60));
  glm::dvec3 at(0, 0, 5);
  const auto towards = [](double degrees) {
    const double angle = radiansFromDegrees(degrees);
    return glm::dvec3(std::sin(angle), 0, -std::cos(angle));
  };
  for (const double degrees : {60.0, 120.0, 180.0}) {
    const int last = static_cast<int>(graph.frusta().size()) - 1;
    graph.bend(last, turnAt(at, towards(degrees - 30), at - 8.0 * towards(degrees)), "turn");
    at += 3.0 * towards(degrees);
  }
  return graph;
}

TEST(GraphDepthSamples, knowWhichFrustumShowsASurface) {
  Mesh triangles = test::randomTriangles(1000, 4);
  for (const glm::uvec3& t : triangles.triangles) {
    const glm::vec3 place = triangles.positions[t.x] * glm::vec3(6, 0.4f, 6) + glm::vec3(2, 0, 4);
    for (int k = 0; k < 3; ++k) {
      triangles.positions[t[k]] = place + 0.2f * triangles.positions[t[k]];
    }
  }
  test::addQuad(triangles, {3, -5, 9}, {8, -5, 9}, {8, 5, 9}, {3, 5, 9});  // at the end of the way back
  const Mesh corridors = test::crossingCorridors();
  const std::vector<std::pair<GraphCamera, const Mesh*>> cases{{turningBack(), &triangles},
                                                               {test::aroundCorners(90), &corridors}};
  for (const auto& [graph, mesh] : cases) {
    const FragmentImage fragments = rasterize(graph, *mesh);
    const GraphDepthSamples samples(graph, fragments);
    std::vector<size_t> shown(graph.frusta().size());
    for (int y = 0; y < graph.height(); ++y) {
      for (int x = 0; x < graph.width(); ++x) {
        const Sample& sample = samples[{x, y}];
        ASSERT_EQ(sample.frustum >= 0, fragments(x, y).covered());
        if (sample.frustum < 0) {
          continue;
        }
        const glm::dvec3 point(positionOf(fragments(x, y), *mesh));
        const GraphCamera::Frustum& frustum = graph.frusta()[static_cast<size_t>(sample.frustum)];
        ++shown[static_cast<size_t>(sample.frustum)];
        // On the plane between two either will do.
        if (std::abs(frustum.plane.height(point)) > 1e-4) {
          ASSERT_EQ(sample.frustum, graph.frustumOf(point)) << x << ' ' << y;
        }
        const double weight = (frustum.pixelFromWorld * glm::dvec4(point, 1)).w;
        ASSERT_NEAR(sample.inverseWeight * weight, 1, 1e-4) << x << ' ' << y;
      }
    }
    for (const size_t count : shown) {
      EXPECT_GT(count, 20u);
    }
  }
}

TEST(GraphDepthSamples, knowWhichFrustaFollowWhich) {
  const GraphCamera graph = test::crossroads();  // root, left, right, far left behind left
  const GraphDepthSamples samples(graph, FragmentImage(graph.width(), graph.height()));
  const std::vector<std::vector<bool>> expected{
      {true, true, true, true}, {false, true, false, true}, {false, false, true, false}, {false, false, false, true}};
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(samples.comesBefore(i, k), expected[static_cast<size_t>(i)][static_cast<size_t>(k)]) << i << ' ' << k;
    }
  }
}

// A plane's 1/w is linear in the image, so what it shows anywhere follows from any pixel.
TEST(GraphDepthSamples, extendPlanes) {
  const GraphCamera graph(smallCamera());
  const Mesh plane = test::tiltedPlane(0.5f);
  const GraphDepthSamples samples(graph, raycast(graph, plane, RayScene(plane)));
  for (const glm::dvec2 place : {glm::dvec2(20.5, 10.5), glm::dvec2(21, 11), glm::dvec2(23.3, 8.1)}) {
    // z = -0.5 y, seen from z = 10 along (0, y', -1) with y' = (30 - v) / focal: y = y' w, w = 10 - z.
    const double slope = (30 - place.y) / static_cast<double>(graph.root().focalPixels());
    EXPECT_NEAR(samples.extended({20, 10}, place).inverseWeight, (1 - 0.5 * slope) / 10, 1e-7);
  }
  EXPECT_EQ(samples.pixelOf({-5, 70}), glm::ivec2(0, 59)) << "the nearest one";
}

TEST(GraphDepthSamples, tilesHoldWhatIsInThem) {
  const GraphCamera graph = test::aroundCorners(90);
  const GraphDepthSamples samples(graph, rasterize(graph, test::crossingCorridors()));
  size_t uniform = 0;
  for (int y = 0; y < graph.height(); ++y) {
    for (int x = 0; x < graph.width(); ++x) {
      const GraphDepthSamples::Tile& tile = samples.tileOf({x, y});
      const Sample& sample = samples[{x, y}];
      EXPECT_TRUE(!tile.uniform || tile.frustum == sample.frustum);
      EXPECT_LE(tile.farthest, sample.inverseWeight);
      EXPECT_GE(tile.nearest, sample.inverseWeight);
      uniform += tile.uniform;
    }
  }
  EXPECT_GT(uniform, 1000u);
}

}  // namespace
}  // namespace ocelli
