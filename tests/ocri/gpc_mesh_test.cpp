// The mesh and the file of a general pinhole's image: its samples lie unevenly, and both must know.
#include <gtest/gtest.h>

#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/reference_image_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

PinholeCamera meshedView() {
  View view;
  view.fovVerticalDegrees = 6;
  return {view, 180, 120};
}

ReferenceImages gpcImages(float zoom, const Mesh& mesh) {
  CameraChoice choice = cameraChoice("gpc");
  choice.gpc = {findGpcSampling("cubic"), {{{0.5f, 0.5f}, {0.6f, 0.6f}, zoom, 0.5f}}};
  return buildReferenceImages(choice, meshedView(), mesh);
}

double areaOf(const Mesh& mesh) {
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    area += static_cast<double>(glm::length(
                glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]))) /
            2;
  }
  return area;
}

// A square of 0.1 at the origin, 10 from the eye, is 11.45 pixels of the pinhole wide, and four times that in a region.
// A mesh covers its samples and half a sample around them.
TEST(GpcMesh, rimsAreAsWideAsSamples) {
  Mesh square;
  test::addWall(square, 0, 0.05f);
  const float footprint = 10 / meshedView().focalPixels();
  const double expected = 0.1 * 0.1;
  const double ofPinhole = areaOf(imageMesh(buildReferenceImages(cameraChoice("di"), meshedView(), square).front()));
  const double ofGpc = areaOf(imageMesh(gpcImages(4, square).front()));
  // Squares at rims overlap the cells beside them by a half of their area, and stand out by at most half a sample:
  // together not more than a sample along each of the four sides.
  EXPECT_NEAR(ofGpc, expected, 4 * 0.1 * static_cast<double>(footprint) / 4);
  EXPECT_NEAR(ofPinhole, expected, 4 * 0.1 * static_cast<double>(footprint));
  EXPECT_LT(std::abs(ofGpc - expected), std::abs(ofPinhole - expected));
}

// A step of four footprints of the pinhole is sixteen of those that the region has: no surface.
TEST(GpcMesh, stepsOfDepthAreJudgedByTheSamples) {
  const float footprint = 10 / meshedView().focalPixels();
  Mesh steps;
  test::addQuad(steps, {-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0});
  test::addQuad(steps, {0, -1, -4 * footprint}, {1, -1, -4 * footprint}, {1, 1, -4 * footprint},
                {0, 1, -4 * footprint});
  const auto across = [&](const Mesh& mesh) {
    size_t count = 0;
    for (const glm::uvec3& t : mesh.triangles) {
      const float a = mesh.positions[t.x].z;
      const float b = mesh.positions[t.y].z;
      const float c = mesh.positions[t.z].z;
      count += std::max({a, b, c}) - std::min({a, b, c}) > 2 * footprint;
    }
    return count;
  };
  EXPECT_GT(across(imageMesh(buildReferenceImages(cameraChoice("di"), meshedView(), steps).front())), 100u);
  // Only in the transition above and below the region samples are as far apart as the step takes.
  const size_t left = across(imageMesh(gpcImages(4, steps).front()));
  EXPECT_LT(left, 120u);
}

// A tilted plane from border to border is one surface, across the edges of the region too.
TEST(GpcMesh, leavesNoHoleInAPlane) {
  const ReferenceImage image = gpcImages(4, test::tiltedPlane(1.5f)).front();
  const Mesh mesh = imageMesh(image);
  EXPECT_EQ(image.sampleCount(), 180u * 120);
  EXPECT_GE(mesh.triangles.size(), 2u * 179 * 119) << "every cell is closed";
}

TEST(GpcMesh, theFileKeepsTheRegions) {
  const test::TemporaryFolder folder;
  const ReferenceImages images = gpcImages(3, test::boxBeforeWall());
  const std::string path = folder.write("gpc.exr", "");
  writeReferenceImages(path, images);
  const ReferenceImage read = readReferenceImages(path).front();
  EXPECT_EQ(read.layout, images.front().layout);
  EXPECT_EQ(read.layout.regions.size(), 1u);
  EXPECT_TRUE(imageMesh(read).triangles == imageMesh(images.front()).triangles);
}

}  // namespace
}  // namespace ocelli
