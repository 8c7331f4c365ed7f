#include "oc_core/depth_rays/rim_cells.h"

#include <gtest/gtest.h>

#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/raycast.h"
#include "tests/depth_rays/sampled_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

/// An image of a scene, to its rims and as sampleCells() has it.
struct Rimmed {
  Mesh mesh;
  ReferenceImages images;
  std::vector<CameraMap> maps;
  RayScene geometry;
  RimCells rims;

  Rimmed(Mesh scene, const std::string& name)
      : mesh(std::move(scene)),
        images(buildReferenceImages(cameraChoice(name), smallCamera(), mesh)),
        maps(cameraMaps(cameraChoice(name), smallCamera(), mesh, images)),
        geometry(mesh),
        rims(rimCells(images[0], maps[0].ray, geometry)) {}
};

/// Of the rays of `samples` places a pixel side: for how many a target and the scene differ about whether they hit.
size_t differences(const DepthImageTarget& target, const RayScene& geometry, int samples) {
  const PinholeCamera camera = smallCamera();
  size_t count = 0;
  for (int y = 0; y < samples * camera.height(); ++y) {
    for (int x = 0; x < samples * camera.width(); ++x) {
      const RayPath ray = camera.rayPath((glm::vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f) /
                                         static_cast<float>(samples));
      count += target.hit(ray).has_value() != geometry.hit(ray).has_value();
    }
  }
  return count;
}

// Seen by its own camera, the outline of a ball ends at most 1/32 of a pixel beside a chord of less than two pixels: of
// the 1.5 % of a pixel that squares are off along some hundred pixels of outline, little is left.
TEST(RimCells, endWhereTheSurfaceEnds) {
  Mesh ball = makeSphere(128);
  const Rimmed rimmed(std::move(ball), "di");
  EXPECT_GT(rimmed.rims.rims, 100u);
  const DepthImageTarget squares(rimmed.images);
  const DepthImageTarget rims = DepthImageTarget::ofCells(rimmed.rims.cells);
  const size_t bySquares = differences(squares, rimmed.geometry, 4);
  const size_t byRims = differences(rims, rimmed.geometry, 4);
  EXPECT_GT(bySquares, 120u) << "of 16 a pixel";
  EXPECT_LT(byRims, bySquares / 4);
}

TEST(RimCells, verticesArePointsOfTheScene) {
  for (const char* name : {"di", "ddoc", "spoc", "cell"}) {
    const Rimmed rimmed(test::thingsBeforeWall(), name);
    ASSERT_EQ(rimmed.rims.pixelOfVertex.size(), rimmed.rims.cells.mesh.positions.size()) << name;
    for (const glm::vec3& position : rimmed.rims.cells.mesh.positions) {
      // Interpolation of depth, and of displacements of other cameras, in single precision.
      ASSERT_TRUE(rimmed.geometry.hasSurfaceNear(position, 2e-3f)) << name;
    }
    for (size_t i = 0; i < rimmed.rims.pixelOfVertex.size(); ++i) {
      ASSERT_TRUE(rimmed.images[0].holds(rimmed.rims.pixelOfVertex[i])) << name;
    }
  }
}

// What both find, they find in the same place, but at rims.
TEST(RimCells, meetWhatSquaresMeetBetweenRims) {
  const Rimmed rimmed(test::thingsBeforeWall(), "di");
  const DepthImageTarget squares(rimmed.images);
  const DepthImageTarget rims = DepthImageTarget::ofCells(rimmed.rims.cells);
  Random random(3);
  size_t both = 0;
  size_t alike = 0;
  for (int i = 0; i < 6000; ++i) {
    const RayPath ray = test::randomRay(random);
    const auto a = squares.hit(ray);
    const auto b = rims.hit(ray);
    both += a && b;
    alike += a && b && std::abs(a->t - b->t) < 1e-4f;
    constexpr int kEachSlowly = 10;
    if (i % kEachSlowly == 0) {
      const auto slow = rims.hitSlowly(ray);
      ASSERT_EQ(b.has_value(), slow.has_value());
      ASSERT_TRUE(!b || b->t == slow->t) << "the pyramid misses none of them";
    }
  }
  EXPECT_GT(both, 300u);
  EXPECT_GT(alike, both * 9 / 10);
}

// Triangles are sorted by the cells that they belong to.
TEST(RimCells, trianglesKnowTheirPixels) {
  const Rimmed rimmed(test::thingsBeforeWall(), "ddoc");
  const SampleCells& cells = rimmed.rims.cells;
  EXPECT_EQ(cells.firstTriangle.back(), cells.mesh.triangles.size());
  for (uint32_t i = 0; i < cells.mesh.triangles.size(); ++i) {
    const SampleCells::Place place = cells.placeOf(i);
    ASSERT_EQ(rimmed.images[0].t.index(place.x, place.y), rimmed.rims.pixelOfVertex[cells.mesh.triangles[i].x]);
  }
}

TEST(RimCells, areOfOneImageThatDisplacesAPinholes) {
  const Mesh mesh = test::thingsBeforeWall();
  test::forEachSampledScene(mesh, smallCamera(), [](const std::string& name, const ReferenceImages& images) {
    const bool isOne = name == "di" || name == "di-wide" || name.starts_with("ddoc") || name == "spoc" ||
                       name == "rppc" || name == "gpc" || name == "cell";
    EXPECT_EQ(canHaveRims(images), isOne) << name;
  });
}

TEST(RimCells, anEmptyImageHasNone) {
  const ReferenceImage image = blankReferenceImage("di", smallCamera().view(), 3, 2);
  const Mesh nothing;
  const RayScene geometry(nothing);
  const RimCells rims = rimCells(
      image, [](const glm::vec2&) { return RayPath{}; }, geometry);
  EXPECT_EQ(rims.rims, 0u);
  EXPECT_TRUE(rims.cells.mesh.triangles.empty());
  EXPECT_EQ(rims.cells.cellCount(), 6u);
}

// Without any ray beside it, a sample is a point, and no ray meets it.
TEST(RimCells, aSampleThatNoRayFindsIsNoSurface) {
  ReferenceImage image = blankReferenceImage("di", smallCamera().view(), 1, 1);
  image.set(0, 0, 10, glm::vec3(1));
  const Mesh nothing;
  const RayScene geometry(nothing);
  const RimCells rims = rimCells(
      image, [](const glm::vec2&) { return RayPath{}; }, geometry);
  EXPECT_EQ(rims.rims, 4u);
  EXPECT_TRUE(rims.cells.mesh.triangles.empty());
}

}  // namespace
}  // namespace ocelli
