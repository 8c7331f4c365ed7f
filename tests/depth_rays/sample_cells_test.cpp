#include "oc_core/depth_rays/sample_cells.h"

#include <gtest/gtest.h>

#include "oc_core/ocri/union_mesh.h"
#include "tests/depth_rays/sampled_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

TEST(SampleCells, areTheMeshOfTheImages) {
  const Mesh mesh = test::thingsBeforeWall();
  test::forEachSampledScene(mesh, smallCamera(), [](const std::string& name, const ReferenceImages& images) {
    const Mesh whole = unionMesh(images);
    const SampleCells cells = sampleCells(images);
    EXPECT_EQ(cells.mesh.positions, whole.positions) << name;
    EXPECT_EQ(cells.mesh.triangles.size(), whole.triangles.size()) << name;
    EXPECT_EQ(cells.firstTriangle.back(), whole.triangles.size()) << name;
    size_t pixels = 0;
    for (const SampleGrid& grid : cells.grids) {
      pixels += static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height);
    }
    EXPECT_EQ(cells.cellCount(), pixels) << name;
  });
}

// A triangle's first corner is the sample of its cell, or a corner of the sample's square, half a pixel away; rows of
// epipolar lines are meshed the other way round, but the corner is the sample all the same.
TEST(SampleCells, trianglesLieAtTheirPixel) {
  const Mesh mesh = test::thingsBeforeWall();
  for (const char* name : {"di", "ldi-4", "eoc-h", "eoc-hv", "corners-4", "panorama"}) {
    const ReferenceImages images = buildReferenceImages(cameraChoice(name), smallCamera(), mesh);
    const SampleCells cells = sampleCells(images);
    size_t samples = 0;
    for (uint32_t i = 0; i < cells.mesh.triangles.size(); ++i) {
      const SampleCells::Place place = cells.placeOf(i);
      const glm::vec3& corner = cells.mesh.positions[cells.mesh.triangles[i].x];
      const ReferenceImage& image = images[place.image];
      const auto point = image.pointOf(place.x, place.y, image.reference());
      ASSERT_TRUE(point) << name;
      const float nearest = glm::distance(*point, corner);
      // Of a panorama 90 pixels wide a pixel covers 0.7 units at the distance of 10.
      EXPECT_LT(nearest, images[0].wrapsAround ? 0.8f : 0.3f) << name;
      samples += nearest < 1e-5f;
    }
    EXPECT_GT(samples, cells.mesh.triangles.size() / 3) << name;
  }
}

TEST(SampleCells, ofNothingAreNone) {
  EXPECT_EQ(sampleCells({}).cellCount(), 0u);
  const SampleCells empty = sampleCells({blankReferenceImage("di", View{}, 5, 3)});
  EXPECT_EQ(empty.cellCount(), 15u);
  EXPECT_TRUE(empty.mesh.triangles.empty());
}

TEST(SampleCellsDeath, refuseATriangleThatTheyLack) {
  EXPECT_DEATH(sampleCells({}).placeOf(0), "no such triangle");
}

}  // namespace
}  // namespace ocelli
