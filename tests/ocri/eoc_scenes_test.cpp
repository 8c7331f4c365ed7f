// The figures that the epipolar occlusion camera must reach, at the size of the published measurements: viewpoints on a
// segment of 8 in, the base pinhole moved along it, error relative to that of the depth image of the base pinhole. The
// scans come from $OCELLI_DATA_DIR.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/row_mesh.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

constexpr float kSegmentRadii = 1.6f;
constexpr int kViewpoints = 9;

struct Figures {
  double strictRatio = 0;
  double thickRatio = 0;
  double widthRatio = 0;
};

Figures figuresOf(const Mesh& scene, const glm::vec3& direction) {
  const PinholeCamera reference(View{}, kDefaultWidth, kDefaultHeight);
  const ViewSegment segment = segmentAround(reference.view(), direction, kSegmentRadii);
  const PinholeCamera base = basePinhole(reference, segment, scene);
  const ReferenceImage eoc = buildEocImage(reference, segment, scene);
  const Mesh eocMesh = rowMesh(eoc);
  const Mesh depthMesh = imageMesh(buildDepthImage(base, scene));
  MissingSamples missing;
  MissingSamples missingFromDepth;
  for (int i = 0; i < kViewpoints; ++i) {
    const glm::vec3 step = (segment.right - segment.left) * (static_cast<float>(i) / (kViewpoints - 1));
    const PinholeCamera moved = basePinhole(reference, {segment.left + step, segment.right + step}, Mesh{});
    const Image<glm::vec4> truth = positionImage(moved, scene);
    missing += countMissing(compareFrames(moved, truth, positionImage(moved, eocMesh)));
    missingFromDepth += countMissing(compareFrames(moved, truth, positionImage(moved, depthMesh)));
  }
  const PinholeCamera plain = basePinhole(reference, segment, Mesh{});
  return {missing.strictRatio() / missingFromDepth.strictRatio(), missing.thickRatio() / missingFromDepth.thickRatio(),
          static_cast<double>(eoc.width()) / plain.width()};
}

struct Goal {
  const char* scene;
  double strictRatio = 0.10;
  double thickRatio = 0.01;
  double widthRatio = 1.5;
};

void expectFigures(const Goal& goal) {
  if (std::string(goal.scene).find("mesh=") != std::string::npos && std::getenv("OCELLI_DATA_DIR") == nullptr) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set: the meshes of the published scenes are not at hand";
  }
  const Mesh scene = loadScene(goal.scene);
  for (const glm::vec3& direction : {kHorizontalSegment, kVerticalSegment}) {
    const Figures figures = figuresOf(scene, direction);
    EXPECT_LE(figures.strictRatio, goal.strictRatio);
    EXPECT_LE(figures.thickRatio, goal.thickRatio);
    EXPECT_LE(figures.widthRatio, goal.widthRatio);
    std::printf("%s %s: strict %.3f thick %.4f of the depth image, width %.2f\n", goal.scene,
                direction == kHorizontalSegment ? "horizontal" : "vertical", figures.strictRatio, figures.thickRatio,
                figures.widthRatio);
  }
}

TEST(EocScenes, bunny) {
  expectFigures({"builtin:room,mesh=bunny.obj"});
}
TEST(EocScenes, dragon) {
  expectFigures({"builtin:room,mesh=dragon.obj"});
}
TEST(EocScenes, armadillo) {
  expectFigures({"builtin:room,mesh=armadillo.ply"});
}
TEST(EocScenes, teapot) {
  expectFigures({"builtin:room,mesh=teapot.obj"});
}
TEST(EocScenes, fourBuddhas) {
  expectFigures({"builtin:statues,mesh=buddha.obj"});
}
TEST(EocScenes, doors) {
  expectFigures({"builtin:doors"});
}
TEST(EocScenes, boxes) {
  expectFigures({"builtin:boxes"});
}
TEST(EocScenes, fence) {
  expectFigures({.scene = "builtin:fence,gap=4", .widthRatio = 1.6});
}
// Gaps of a pixel: what L sees through them says little of what lies behind. The depth image lacks it in whole
// stretches, the EOC nowhere.
TEST(EocScenes, fenceWithGapsOfAPixel) {
  expectFigures({.scene = "builtin:fence,gap=1", .strictRatio = 0.44, .widthRatio = 1.6});
}
// Without a background the depth image lacks little, and a third of that are rims, whose samples lie too far apart in
// depth for the strict measure from any viewpoint but L. The EOC has the same rims.
TEST(EocScenes, teapotBeforeNothing) {
  expectFigures({.scene = "builtin:teapot", .strictRatio = 0.30});
}

}  // namespace
}  // namespace ocelli
