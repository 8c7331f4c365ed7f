#include "oc_core/ocri/cell_builder.h"

#include <gtest/gtest.h>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/render/raycast.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

MissingSamples missingOverTheEdges(const Mesh& mesh, const Mesh& representation) {
  MissingSamples missing;
  for (const View& view : ViewCell{}.edgeViews(View{})) {
    const PinholeCamera camera(view, kWidth, kHeight);
    missing += countMissing(compareFrames(camera, positionImage(camera, mesh), positionImage(camera, representation)));
  }
  return missing;
}

TEST(CellBuilder, holdsWhatTheDepthImageLacksInBoundedSamples) {
  const Mesh mesh = test::boxBeforeWall();
  const ReferenceImage depth = buildDepthImage(smallCamera(), mesh);
  const ReferenceImage cell = buildCellImage(buildCellCamera(smallCamera(), mesh), mesh);
  const MissingSamples lacks = missingOverTheEdges(mesh, unionMesh({depth}));
  const MissingSamples left = missingOverTheEdges(mesh, unionMesh({cell}));
  ASSERT_GT(lacks.strict, 1000u);
  EXPECT_LT(left.strict, lacks.strict * 15 / 100) << "the goal for every scene";
  EXPECT_LT(left.thick, lacks.thick / 100);
  EXPECT_LE(static_cast<double>(cell.sampleCount()), 1.3 * static_cast<double>(depth.sampleCount()));
}

TEST(CellBuilder, referencePixelsAreThoseOfTheDepthImage) {
  const Mesh mesh = test::boxBeforeWall();
  const ReferenceImage depth = buildDepthImage(smallCamera(), mesh);
  const ReferenceImage cell = buildCellImage(buildCellCamera(smallCamera(), mesh), mesh);
  EXPECT_EQ(cell.pinholeSize, glm::ivec2(kWidth, kHeight));
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      EXPECT_NEAR(cell.t(x, y), depth.t(x, y), 1e-5f);
      EXPECT_EQ(cell.color(x, y), depth.color(x, y));
    }
  }
}

// Samples of satellites project where they stand, but for those on seams, which an earlier viewpoint holds too.
TEST(CellBuilder, samplesStandWhereTheCameraProjectsThem) {
  const Mesh mesh = test::boxBeforeWall();
  const CellCamera camera = buildCellCamera(smallCamera(), mesh);
  const ReferenceImage image = buildCellImage(camera, mesh);
  size_t own = 0;
  size_t seams = 0;
  for (int y = kHeight; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!image.holds(x, y)) {
        continue;
      }
      const std::optional<ImagePoint> q = camera.project(*image.reference().unproject(image.undistorted(x, y)));
      ASSERT_TRUE(q);
      const bool here = std::abs(q->u - (static_cast<float>(x) + 0.5f)) < 0.02f &&
                        std::abs(q->v - (static_cast<float>(y) + 0.5f)) < 0.02f;
      own += here;
      seams += !here;
    }
  }
  EXPECT_GT(own, 300u);
  EXPECT_LT(seams, own) << "one pixel around each group, and the repeated rows and columns of tiles";
}

TEST(CellBuilder, agreesWithItsRaysCast) {
  const Mesh mesh = test::boxBeforeWall();
  const CellCamera camera = buildCellCamera(smallCamera(), mesh);
  const ReferenceImage drawn = buildCellImage(camera, mesh);
  const ReferenceImage cast = cellImage(camera, raycast(camera, mesh, RayScene(mesh)), mesh);
  size_t both = 0;
  size_t different = 0;
  size_t withoutRay = 0;
  for (size_t i = 0; i < drawn.t.size(); ++i) {
    if (drawn.holds(i) && cast.holds(i)) {
      ++both;
      different += std::abs(drawn.t[i] - cast.t[i]) > 0.05f;
    } else {
      EXPECT_EQ(cast.t[i], 0) << "a ray finds nothing that the image does not hold";
      withoutRay += drawn.holds(i);
    }
  }
  EXPECT_GT(both, static_cast<size_t>(kWidth * kHeight));
  EXPECT_LE(different, 8u) << "rounding at silhouettes";
  EXPECT_LT(withoutRay, (both - static_cast<size_t>(kWidth * kHeight)) * 2) << "seams belong to earlier viewpoints";
}

TEST(CellBuilder, keepsToTheSamplesItIsGiven) {
  const Mesh mesh = test::boxBeforeWall();
  const auto samples = static_cast<float>(buildDepthImage(smallCamera(), mesh).sampleCount());
  for (const float most : {1.0f, 1.03f, 1.1f, 3.0f}) {
    CellOptions options;
    options.maxSamples = most;
    const ReferenceImage cell = buildCellImage(buildCellCamera(smallCamera(), mesh, options), mesh);
    EXPECT_LE(static_cast<float>(cell.sampleCount()), most * samples) << most;
  }
}

TEST(CellBuilder, satellitesStandInTheCell) {
  const Mesh mesh = test::boxBeforeWall();
  for (const ViewCell::Shape shape : {ViewCell::Shape::kCube, ViewCell::Shape::kSphere, ViewCell::Shape::kSegment}) {
    CellOptions options;
    options.cell.shape = shape;
    options.cell.segmentDirection = {0, 3, 0};
    options.minShare = 0;
    options.maxSatellites = 40;
    options.maxSamples = 3;
    const CellCamera camera = buildCellCamera(smallCamera(), mesh, options);
    EXPECT_GT(camera.viewpoints().size(), 2u);
    for (const CellCamera::Viewpoint& viewpoint : camera.viewpoints()) {
      const glm::vec3 offset = glm::abs(viewpoint.camera.eye() - smallCamera().eye());
      constexpr float kHalf = 0.8f + 1e-5f;
      EXPECT_LE(std::max({offset.x, offset.y, offset.z}), kHalf);
      if (shape == ViewCell::Shape::kSphere) {
        EXPECT_LE(glm::length(offset), kHalf);
      } else if (shape == ViewCell::Shape::kSegment) {
        EXPECT_LE(std::max(offset.x, offset.z), 1e-5f);
      }
    }
  }
}

TEST(CellBuilder, wallNeedsNoSatelliteWithinItsBorders) {
  CellOptions options;
  options.cell.sideRadii = 0.1f;
  const CellCamera camera = buildCellCamera(smallCamera(), test::wall(0), options);
  EXPECT_LE(camera.viewpoints().size(), 9u) << "only the borders of the image show something new";
  options.maxSatellites = 0;
  EXPECT_EQ(buildCellCamera(smallCamera(), test::boxBeforeWall(), options).height(), kHeight);
}

TEST(CellBuilder, nothingSeenGivesAnEmptyImage) {
  View away;
  away.target = {0, 0, 20};
  away.fovVerticalDegrees = 20;
  const PinholeCamera camera(away, kWidth, kHeight);
  const Mesh mesh = test::boxBeforeWall();
  EXPECT_EQ(buildCellImage(buildCellCamera(camera, mesh), mesh).sampleCount(), 0u);
  EXPECT_EQ(buildCellImage(buildCellCamera(camera, {}), {}).sampleCount(), 0u);
}

TEST(CellBuilder, sameBytesWithAnyNumberOfThreads) {
  const Mesh mesh = test::boxBeforeWall();
  ReferenceImage first;
  for (const int threads : {1, 2, 8}) {
    setThreadCount(threads);
    const ReferenceImage image = buildCellImage(buildCellCamera(smallCamera(), mesh), mesh);
    if (first.t.empty()) {
      first = image;
    }
    EXPECT_TRUE(test::sameBytes(image.t, first.t)) << threads;
    EXPECT_TRUE(test::sameBytes(image.color, first.color)) << threads;
    EXPECT_TRUE(test::sameBytes(image.displacement, first.displacement)) << threads;
  }
  setThreadCount(0);
}

}  // namespace
}  // namespace ocelli
