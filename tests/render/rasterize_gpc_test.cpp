#include "oc_core/render/rasterize_gpc.h"

#include <gtest/gtest.h>

#include "oc_core/base/parallel.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/render/camera_cases.h"

namespace ocelli {
namespace {

PinholeCamera largerPinhole() {
  return {View{}, 360, 240};
}

std::vector<GpcLayout> layouts() {
  std::vector<GpcLayout> all;
  for (const GpcSampling& each : gpcSamplings()) {
    all.push_back(test::oneRegion(each.name));
    all.push_back(test::twoRegions(each.name));
  }
  all.push_back({findGpcSampling("cubic"), {GpcRegion{}}});
  return all;
}

struct Disagreement {
  size_t covered = 0;
  size_t coverage = 0;  ///< one holds a sample and the other none
  size_t depth = 0;     ///< by more than what the neighbours' rays see
};

Disagreement disagreement(const FragmentImage& drawn, const FragmentImage& cast) {
  Disagreement found;
  for (int y = 0; y < drawn.height(); ++y) {
    for (int x = 0; x < drawn.width(); ++x) {
      const Fragment& a = drawn(x, y);
      const Fragment& b = cast(x, y);
      found.covered += b.covered();
      found.coverage += a.covered() != b.covered();
      found.depth += a.covered() && b.covered() && std::abs(a.t - b.t) > 1e-4f * b.t;
    }
  }
  return found;
}

// Triangles of all sizes, with edges that cross every zone.
TEST(RasterizeGpc, seesWhatItsRaysMeet) {
  const Mesh mesh = test::randomTriangles(300, 23);
  for (const GpcLayout& layout : layouts()) {
    const GpcCamera camera(largerPinhole(), layout);
    const Disagreement found = disagreement(rasterizeGpc(camera, mesh), raycast(camera, mesh, RayScene(mesh)));
    EXPECT_GT(found.covered, 20000u);
    // Snapping to 1/256 pixel, on pixels at edges: some hundredths of the pixels.
    EXPECT_LE(found.coverage + found.depth, found.covered / 1000) << jsonText(layout);
  }
}

// A wall of small triangles leaves no hole: not within a zone, and not where two of them meet.
TEST(RasterizeGpc, leavesNoGaps) {
  Mesh wall;
  constexpr int kSteps = 157;
  for (int y = 0; y <= kSteps; ++y) {
    for (int x = 0; x <= kSteps; ++x) {
      wall.positions.emplace_back(6.0f * static_cast<float>(x) / kSteps - 3, 6.0f * static_cast<float>(y) / kSteps - 3,
                                  0.03f * std::sin(static_cast<float>(x + y)));
      if (x < kSteps && y < kSteps) {
        const auto at = static_cast<uint32_t>(y * (kSteps + 1) + x);
        wall.triangles.emplace_back(at, at + 1, at + kSteps + 2);
        wall.triangles.emplace_back(at, at + kSteps + 2, at + kSteps + 1);
      }
    }
  }
  for (const GpcLayout& layout : layouts()) {
    const GpcCamera camera(largerPinhole(), layout);
    const FragmentImage image = rasterizeGpc(camera, wall);
    const FragmentImage cast = raycast(camera, wall, RayScene(wall));
    size_t holes = 0;
    float worst = 0;
    for (size_t i = 0; i < image.size(); ++i) {
      holes += !image[i].covered();
      worst = std::max(worst, std::abs(image[i].t - cast[i].t));
    }
    EXPECT_EQ(holes, 0u) << jsonText(layout);
    // It hides nothing of itself. Its steepest slope is 0.013 a pixel of the pinhole; samples may be off by 3/32 of
    // one.
    EXPECT_LT(worst, 0.005f) << jsonText(layout);
  }
}

// Small triangles, most of which are filled with straight edges: as those that are tried pixel by pixel, but for what
// lies within a chord of an edge.
TEST(RasterizeGpc, straightEdgesAreWithinAChordOfBentOnes) {
  const Mesh mesh = loadScene("builtin:statues,triangles=100000");
  View view;
  view.target = {0, -0.2f, 0};
  view.fovVerticalDegrees = 8;
  const PinholeCamera pinhole(view, 720, 480);
  for (const GpcLayout& layout : layouts()) {
    const GpcCamera camera(pinhole, layout);
    const ProjectedMesh projected(pinhole, mesh);
    const FragmentImage drawn = rasterizeGpc(camera, projected);
    const FragmentImage exact = rasterizeGpcExactly(camera, projected);
    size_t covered = 0;
    size_t others = 0;
    size_t different = 0;
    for (size_t i = 0; i < drawn.size(); ++i) {
      covered += exact[i].covered();
      others += drawn[i].triangle != exact[i].triangle;
      different += drawn[i].covered() != exact[i].covered();
      if (drawn[i].covered() && drawn[i].triangle == exact[i].triangle) {
        // Of these triangles no point is a chord away in depth: they are a hundredth of the distance large.
        ASSERT_NEAR(drawn[i].t, exact[i].t, 1e-3f * exact[i].t);
      }
    }
    EXPECT_GT(covered, drawn.size() / 3) << jsonText(layout);
    // Triangles are a few pixels large, so some thousandths of the pixels lie within a chord of an edge between two,
    // and which of them they show is open. Less than a tenth of the edges that are seen are silhouettes.
    EXPECT_LE(others, covered / 200) << jsonText(layout);
    EXPECT_LE(different, covered / 5000) << jsonText(layout);
    EXPECT_GT(others, 0u) << "all is drawn pixel by pixel";
  }
}

TEST(RasterizeGpc, isTheSameForAnyNumberOfThreads) {
  const Mesh mesh = loadScene("builtin:statues,triangles=20000");
  const GpcCamera camera(largerPinhole(), test::twoRegions("cubic"));
  setThreadCount(1);
  const FragmentImage one = rasterizeGpc(camera, mesh);
  setThreadCount(3);
  const FragmentImage three = rasterizeGpc(camera, mesh);
  setThreadCount(0);
  EXPECT_EQ(one, three);
}

// As many zones as there may be.
TEST(RasterizeGpc, drawsManyRegions) {
  GpcLayout layout{findGpcSampling("cubic"), {}};
  for (size_t i = 0; i < GpcLayout::kMaxRegions; ++i) {
    const glm::vec2 cell(static_cast<float>(i % 16), static_cast<float>(i / 16));
    layout.regions.push_back({(cell + 0.5f) / 16.0f, glm::vec2(0.03f), 2, 0.9f});
  }
  const Mesh mesh = test::randomTriangles(300, 29);
  const GpcCamera camera(largerPinhole(), layout);
  const Disagreement found = disagreement(rasterizeGpc(camera, mesh), raycast(camera, mesh, RayScene(mesh)));
  EXPECT_GT(found.covered, 20000u);
  EXPECT_LE(found.coverage + found.depth, found.covered / 1000);
}

// Without a region, and with a zoom of 1, it is the pinhole: bit for bit around the zones.
TEST(RasterizeGpc, withoutRegionsItIsThePinhole) {
  const Mesh mesh = loadScene("builtin:boxes");
  const FragmentImage expected = rasterize(largerPinhole(), mesh);
  EXPECT_EQ(rasterizeGpc(GpcCamera(largerPinhole(), {findGpcSampling("cubic"), {}}), mesh), expected);
  const GpcCamera camera(largerPinhole(), test::twoRegions("cubic"));
  const FragmentImage image = rasterizeGpc(camera, mesh);
  size_t compared = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (camera.map().zoneAt(glm::dvec2(x, y) + 0.5) == nullptr) {
        ++compared;
        ASSERT_EQ(image(x, y), expected(x, y)) << x << ", " << y;
      }
    }
  }
  EXPECT_GT(compared, 10000u);
}

// Its inner rectangle is the image of a pinhole with a narrower view: f' = zoom f, so tan(fov' / 2) = tan(fov / 2) / 4
// for a region as large as the image would be, of which the middle is compared.
TEST(RasterizeGpc, aRegionIsAPinholeThatZooms) {
  const Mesh mesh = loadScene("builtin:teapot");
  View view;
  view.fovVerticalDegrees = 20;
  const PinholeCamera reference(view, 360, 240);
  const GpcCamera camera(reference, {findGpcSampling("cubic"), {{{0.5f, 0.5f}, {0.5f, 0.5f}, 4, 1}}});
  View narrow = view;
  narrow.fovVerticalDegrees = degreesFromRadians(2 * std::atan(std::tan(radiansFromDegrees(10)) / 4));
  const FragmentImage expected = rasterize(PinholeCamera(narrow, 360, 240), mesh);
  const FragmentImage image = rasterizeGpc(camera, mesh);
  size_t different = 0;
  for (int y = 60; y < 180; ++y) {
    for (int x = 90; x < 270; ++x) {
      // Vertices of either are single floats before they are snapped: 1e-3 pixels may bring them over an edge.
      different += image(x, y).covered() != expected(x, y).covered() ||
                   std::abs(image(x, y).t - expected(x, y).t) > 1e-4f * expected(x, y).t;
    }
  }
  EXPECT_LE(different, 120u * 180 / 500);
}

// Clipped at the near plane and far out beyond the borders.
TEST(RasterizeGpc, drawsWhatRunsUnderTheEye) {
  const Mesh floor{{{-1000, -1, 1000}, {1000, -1, 1000}, {0, -1, -3000}}, {}, {{0, 1, 2}}};
  View view;
  view.eye = {0, 0, 0};
  view.target = {0, -0.5f, -1};
  view.fovVerticalDegrees = 60;
  view.zNear = 1.5f;
  const GpcCamera camera(PinholeCamera(view, 360, 240), test::oneRegion("cubic"));
  const Disagreement found = disagreement(rasterizeGpc(camera, floor), raycast(camera, floor, RayScene(floor)));
  EXPECT_GT(found.covered, 20000u);
  EXPECT_LE(found.coverage, 100u) << "along the near plane and the horizon";
}

}  // namespace
}  // namespace ocelli
