#include "oc_core/volume_ocri/volume_first_hits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/evaluation/evaluation.h"
#include "oc_core/isosurface/isosurface.h"
#include "oc_core/ocri/union_mesh.h"
#include "tests/volume_ocri/block_volumes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

PinholeCamera smallCamera() {
  return {View{}, 90, 60};
}

ReferenceImages imagesOf(const VolumeFirstHits& volume, const char* camera) {
  return buildReferenceImages(cameraChoice(camera), smallCamera(), volume.renderer());
}

TEST(VolumeFirstHits, ADepthImageShowsTheSurfacesInTheirColours) {
  const VolumeFirstHits volume(test::blockBeforeWall());
  const ReferenceImage image = imagesOf(volume, "di")[0];
  // The eye is at z = 10; the block's front at 0.5, the wall's at -0.5. Between outer voxels the field falls from 1
  // before the face to 0 behind it, and the light is lost within a voxel.
  EXPECT_NEAR(image.t(45, 30), 9.5f, test::kBlocksSpacing);
  EXPECT_NEAR(image.t(45, 10), 10.5f, test::kBlocksSpacing);
  EXPECT_GT(image.color(45, 30).r, 3 * image.color(45, 30).g);
  EXPECT_NEAR(image.color(45, 10).r, image.color(45, 10).g, 1e-3f);
}

TEST(VolumeFirstHits, LayersAreWhatLiesBehindAndNotTheInside) {
  const VolumeFirstHits volume(test::blockBeforeWall());
  const ReferenceImages layers = imagesOf(volume, "ldi-3");
  ASSERT_EQ(layers.size(), 2u);
  // As above: the light is lost within a voxel.
  EXPECT_NEAR(layers[0].t(45, 30), 9.5f, test::kBlocksSpacing);
  EXPECT_NEAR(layers[1].t(45, 30), 10.5f, test::kBlocksSpacing);
  EXPECT_FALSE(layers[1].holds(45, 10));
}

/// An image with the isosurface at the value where the transfer function turns opaque, and one of the volume.
TEST(VolumeFirstHits, AnOpaqueVolumeAndItsIsosurfaceLieInEachOther) {
  if (!canExtractIsosurfaces()) {
    GTEST_SKIP() << "this build has no isosurfaces";
  }
  constexpr int kEdge = 40;
  VolumeGrid grid{.size = glm::ivec3(kEdge)};
  const double spacing = 2.0 / kEdge;
  // Two axes change places, and the box is no cube.
  grid.worldFromIndex = glm::dmat4(glm::dvec4(0, spacing, 0, 0), glm::dvec4(spacing, 0, 0, 0),
                                   glm::dvec4(0, 0, 0.8 * spacing, 0), glm::dvec4(-0.9, -1, -0.7, 1));
  // Opaque within a twentieth of a voxel from the value 0 on.
  TransferFunction transfer({{0, {1, 1, 1}, 0}, {0, {1, 1, 1}, 0.9999}}, spacing / 20);
  VolumeScene scene = test::sceneOfVoxels(
      grid,
      test::voxelsOf(grid.size, [](const glm::dvec3& p) { return 14 - glm::distance(p, glm::dvec3(19, 21, 18)); }),
      std::move(transfer));
  const Mesh mesh = isosurface(scene, {.value = 0}, "the volume");
  const ReferenceImage ofMesh = buildDepthImage(smallCamera(), mesh);
  const VolumeFirstHits volume(std::move(scene), {.step = 0.05});
  const ReferenceImage ofVolume = imagesOf(volume, "di")[0];
  const RayScene surface(mesh);
  size_t both = 0;
  size_t one = 0;
  for (int y = 0; y < ofMesh.height(); ++y) {
    for (int x = 0; x < ofMesh.width(); ++x) {
      one += ofMesh.holds(x, y) != ofVolume.holds(x, y);
      if (ofMesh.holds(x, y) && ofVolume.holds(x, y)) {
        ++both;
        // Its light is lost in a twentieth of a voxel, and steps are as long.
        EXPECT_TRUE(surface.hasSurfaceNear(*ofVolume.pointOf(x, y, smallCamera()), 0.1f * static_cast<float>(spacing)))
            << x << ", " << y;
      }
    }
  }
  EXPECT_GT(both, 300u);
  EXPECT_LT(one, 12u);  // of some 70 pixels along the silhouette
}

EvaluationOptions smallEvaluation() {
  EvaluationOptions options;
  options.width = 90;
  options.height = 60;
  options.interiorViews = 2;
  return options;
}

TEST(VolumeFirstHits, OcclusionCamerasLackLessOfAVolumeThanADepthImage) {
  const VolumeFirstHits volume(test::blockBeforeWall());
  const TargetScene scene = volume.evaluated();
  Evaluator evaluator(scene, smallEvaluation());
  const RepresentationFigures di = evaluator.measure(cameraChoice("di"));
  // The block hides a frame of the wall, about a pixel wide on average: some 40 of 5000 samples.
  EXPECT_GT(di.edges.strictRatio(), 0.005);
  // The reference view hides nothing from itself; samples along the silhouette may fall on its other side.
  EXPECT_LT(di.reference.strictRatio(), 0.002);
  EXPECT_EQ(di.strictRatioToDi, 1);
  for (const char* name : {"ddoc", "eoc-hv", "ldi-2"}) {
    const RepresentationFigures figures = evaluator.measure(cameraChoice(name));
    // What they are for: to show most of what a pinhole misses.
    EXPECT_LT(figures.strictRatioToDi, 0.5) << name;
    // The mesh joins nothing over what is clear: but for a pixel or two where it ends.
    EXPECT_LT(figures.edges.falseSkinRatio(), 0.005) << name;
  }
}

TEST(VolumeFirstHits, WhatJoinsTheBlockAndTheWallIsFalse) {
  const VolumeFirstHits volume(test::blockBeforeWall());
  const TargetScene scene = volume.evaluated();
  EXPECT_TRUE(scene.hasSurfaceNear({0.1f, 0.1f, 0.5f}, test::kBlocksSpacing));
  EXPECT_TRUE(scene.hasSurfaceNear({0.1f, 0.1f, 0.4f}, test::kBlocksSpacing));
  EXPECT_FALSE(scene.hasSurfaceNear({0.3f, 0.1f, 0}, test::kBlocksSpacing));
}

TEST(VolumeFirstHits, ErrorsSayWhatToDo) {
  const auto errorOf = [&](const char* name, double opacity, const VolumeScene& scene) -> std::string {
    const VolumeFirstHits volume(scene, {.depthOpacity = opacity});
    try {
      imagesOf(volume, name);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(errorOf("simplified", 0.5, test::blockBeforeWall()), HasSubstr("--iso VALUE"));
  VolumeScene haze = test::blockBeforeWall();
  haze.appearance.transfer = TransferFunction({{0, glm::dvec3(1), 0.3}}, 2);
  EXPECT_THAT(errorOf("di", 0.2, haze), HasSubstr("no error"));
  EXPECT_THAT(errorOf("di", 0.7, haze), HasSubstr("--opacity"));
}

TEST(VolumeFirstHits, AreToldApart) {
  const std::string first = VolumeFirstHits(test::blockBeforeWall()).identity();
  EXPECT_EQ(VolumeFirstHits(test::blockBeforeWall()).identity(), first);
  EXPECT_NE(VolumeFirstHits(test::blockBeforeWall(), {.depthOpacity = 0.4}).identity(), first);
  EXPECT_NE(VolumeFirstHits(test::sceneOfBlocks({})).identity(), first);
  VolumeScene other = test::blockBeforeWall();
  other.appearance.shading.isOn = true;
  EXPECT_NE(VolumeFirstHits(other).identity(), first);
  VolumeScene surfaces = test::blockBeforeWall();
  surfaces.surfaces.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  surfaces.surfaces.triangles = {{0, 1, 2}};
  const std::string half = VolumeFirstHits(surfaces).identity();
  EXPECT_NE(half, first);
  surfaces.surfaces.triangles = {{0, 2, 3}};
  const std::string otherHalf = VolumeFirstHits(surfaces).identity();
  EXPECT_NE(otherHalf, half) << "of the same corners";
  surfaces.surfaces.colors.assign(4, {1, 0, 0});
  EXPECT_NE(VolumeFirstHits(surfaces).identity(), otherHalf);
  EXPECT_EQ(VolumeFirstHits(test::blockBeforeWall(), {.depthOpacity = 0.4}).description(),
            "64 x 64 x 64 voxels, first hits at an opacity of 0.4");
}

}  // namespace
}  // namespace ocelli
