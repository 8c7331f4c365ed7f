// What culling passes over changes no pixel: images of a few pixels and of several regions, bit by bit against pieces
// that are drawn without it, and against rays.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "oc_core/render/bend_rasterizer.h"
#include "oc_core/render/camera_segments.h"
#include "oc_core/render/rasterize_curved.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/render/raycast.h"
#include "oc_core/render/segment_rasterizer.h"
#include "oc_core/scene/densify.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/render/ray_agreement.h"
#include "tests/render/render_checks.h"
#include "tests/render/uncut_pieces.h"

namespace ocelli {
namespace {

using test::Disagreement;
using test::disagreement;
using test::turnAt;
using test::UncutPiece;

FragmentImage uncut(const GraphCamera& camera, const Mesh& mesh) {
  const MeshBlocks blocks(mesh);
  const PixelLeaves leaves = leavesOf(camera);
  const std::vector<StraightSegment> segments = segmentsOf(camera, leaves);
  RayPieces pieces;
  for (const StraightSegment& segment : segments) {
    pieces.push_back(std::make_unique<UncutPiece>(
        std::make_unique<SegmentRasterizer>(segment, mesh, blocks, camera.width(), camera.height()), blocks,
        PixelBounds{0, 0, camera.width(), camera.height()}));
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a->order() < b->order(); });
  return fragmentsOf(camera, orderedBufferOf(pieces, leaves, blocks), mesh);
}

FragmentImage uncut(const CurvedRayCamera& camera, const Mesh& mesh) {
  const MeshBlocks blocks(mesh);
  const PixelBounds image{0, 0, camera.width(), camera.height()};
  const std::vector<StraightSegment> segments = segmentsOf(camera);
  RayPieces pieces;
  for (size_t i = 0; i < segments.size(); ++i) {
    pieces.push_back(std::make_unique<UncutPiece>(
        std::make_unique<SegmentRasterizer>(segments[i], mesh, blocks, image.x1, image.y1), blocks, image));
    if (i + 1 < segments.size()) {
      pieces.push_back(std::make_unique<UncutPiece>(
          std::make_unique<BendRasterizer>(camera, i, static_cast<uint8_t>(2 * i + 1), mesh, blocks), blocks, image));
    }
  }
  return fragmentsOf(camera, orderedBufferOf(pieces, PixelLeaves(image.x1, image.y1, 0), blocks), mesh);
}

/// Frusta that end among the objects.
GraphCamera limitedCrossroads(const PinholeCamera& camera) {
  GraphCamera graph = test::crossroads(camera);
  graph.limit(1, Plane::through({0, 0, -0.4}, {0.1, 0, -1}));
  graph.limit(3, Plane::through({0, 0, -4}, {0, 0, -1}));
  return graph;
}

/// Rays of a part bend, those around it run on to a limit.
GraphCamera door(const PinholeCamera& camera) {
  GraphCamera graph(camera);
  const double w = camera.width();
  const double h = camera.height();
  graph.bend(0, turnAt({0, 0, 0.2}, {0.2, 0, -1}, {0.3, 0.1, 40}), "door",
             {{0.3 * w, 0.25 * h}, {0.7 * w, 0.3 * h}, {0.65 * w, 0.8 * h}});
  graph.limit(0, Plane::through({0, 0, -0.1}, {0, 0, -1}));
  return graph;
}

/// Of all kinds of cameras that can be made at a pinhole: some bends need more in view than a narrow one has. Returns
/// how many these are.
template <class Visit>
size_t forEachCamera(const PinholeCamera& pinhole, const Visit& visit) {
  size_t made = 0;
  const auto attempt = [&](const auto& make) {
    std::optional<decltype(make())> camera;
    try {
      camera.emplace(make());
    } catch (const InputError&) {
      return;
    }
    visit(*camera);
    ++made;
  };
  attempt([&] { return GraphCamera(pinhole); });
  attempt([&] { return test::crossroads(pinhole); });
  attempt([&] { return limitedCrossroads(pinhole); });
  attempt([&] { return door(pinhole); });
  attempt([&] { return CurvedRayCamera(pinhole); });
  attempt([&] { return test::bendingRight(pinhole); });
  attempt([&] { return test::bendingTwice(pinhole); });
  attempt([&] { return test::bendingTwice(pinhole, ArcModel::kBezier); });
  return made;
}

/// As wide or as high as the default view of 3:2.
PinholeCamera fitting(int width, int height) {
  View view;
  const double tangent = std::tan(radiansFromDegrees(view.fovVerticalDegrees) / 2);
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(tangent * std::min(1.0, 1.5 * height / width)));
  return {view, width, height};
}

/// From where the test cameras stand, one pixel of the default view's image, near the line where rays part.
PinholeCamera onePixel(Random& random) {
  View view;
  view.target = {random.inRange(-0.004f, 0.004f), random.inRange(-0.5f, 0.5f), 0};
  view.fovVerticalDegrees = random.inRange(0.2f, 0.5f);
  return {view, 1, 1};
}

TEST(Culling, changesNoPixelOfImagesOfAnySize) {
  size_t covered = 0;
  size_t made = 0;
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  // One pixel, rows and columns, a pixel more than a region, tiles that are cut.
  for (const auto& [width, height] : {std::pair(1, 1), {2, 1}, {1, 3}, {5, 4}, {9, 8}, {321, 2}, {3, 97}, {330, 100}}) {
    made += forEachCamera(fitting(width, height), [&](const auto& camera) {
      const FragmentImage drawn = rasterize(camera, mesh);
      covered += test::coveredPixels(drawn);
      EXPECT_EQ(drawn, uncut(camera, mesh)) << width << "x" << height;
    });
  }
  EXPECT_GT(covered, 20'000u);
  EXPECT_GT(made, 50u);
}

TEST(Culling, changesNoPixelOfImagesOfOnePixel) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const RayScene rays(mesh);
  Random random(11);
  Disagreement all;
  size_t made = 0;
  for (int i = 0; i < 60; ++i) {
    made += forEachCamera(onePixel(random), [&](const auto& camera) {
      const FragmentImage drawn = rasterize(camera, mesh);
      if (i < 20) {  // which takes most of the time
        EXPECT_EQ(drawn, uncut(camera, mesh)) << i;
      }
      // Vertices are snapped to 1/256 of a pixel, and these pixels are up to six times as large as where 1e-4 holds.
      const Disagreement d = disagreement(raycast(camera, mesh, rays), drawn, 6e-4f);
      all.samples += d.samples;
      all.differing += d.differing;
    });
  }
  // As of larger images (rasterize_graph_test.cpp): rounding decides at edges.
  EXPECT_GT(made, 400u);
  EXPECT_GT(all.samples, 200u);
  EXPECT_LE(all.differing, all.samples / 200) << all;
}

TEST(Culling, leavesOutWholeBlocksThatAreNotFinite) {
  Mesh mesh = loadScene("builtin:boxes", {}, {});
  densify(mesh, 4000);
  const Mesh without = test::breakTriangles(mesh);
  ASSERT_GT(mesh.triangles.size(), 2048u);
  const MeshBlocks blocks(mesh);
  EXPECT_TRUE(blocks[1].box.empty());
  size_t seen = 0;
  blocks.forEachWithin({}, [&](uint32_t block, Placement) {
    ++seen;
    EXPECT_TRUE(block != 1 && block / MeshBlocks::kRun != 1) << block;
  });
  EXPECT_GT(seen, 0u);
  const size_t made = forEachCamera(PinholeCamera(View{}, 180, 120), [&](const auto& camera) {
    const FragmentImage drawn = rasterize(camera, mesh);
    EXPECT_GT(test::coveredPixels(drawn), 1000u);
    EXPECT_EQ(drawn, rasterize(camera, without));
    EXPECT_EQ(drawn, rasterize(camera, mesh, MeshBlocks(mesh, MeshBlocks::Order::kInSpace)));
  });
  EXPECT_EQ(made, 8u);
}

}  // namespace
}  // namespace ocelli
