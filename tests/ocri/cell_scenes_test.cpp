// The goals of the cell camera on whole scenes: over the edges of the 8 in cube at most 15 % of the depth image's
// strict error and 1 % of its thick one, at 1.3 times its samples, and at most 0.2 % missing at the reference viewpoint
// (docs/choosing.md has what is reached).
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "oc_core/base/conventions.h"
#include "oc_core/evaluation/evaluation.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

void expectGoals(const std::string& source, double strictRatio = 0.15, double atReference = 0.002) {
  if (source.find("mesh=") != std::string::npos && std::getenv("OCELLI_DATA_DIR") == nullptr) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set: the meshes of the published scenes are not at hand";
  }
  EvaluationOptions options;
  options.width = kDefaultWidth;
  options.height = kDefaultHeight;
  options.interiorViews = 0;
  const std::vector<RepresentationFigures> figures =
      evaluate(loadScene(source), {cameraChoice("di"), cameraChoice("cell")}, options);
  const RepresentationFigures& depth = figures[0];
  const RepresentationFigures& cell = figures[1];
  EXPECT_LE(cell.strictRatioToDi, strictRatio) << source;
  EXPECT_LE(cell.thickRatioToDi, 0.01) << source;
  EXPECT_LE(static_cast<double>(cell.samples), 1.3 * static_cast<double>(depth.samples)) << source;
  EXPECT_LE(cell.reference.strictRatio(), atReference) << source;
}

TEST(CellScenes, bunny) {
  expectGoals("builtin:room,mesh=bunny.obj");
}
TEST(CellScenes, dragon) {
  expectGoals("builtin:room,mesh=dragon.obj");
}
TEST(CellScenes, armadillo) {
  expectGoals("builtin:room,mesh=armadillo.ply");
}
TEST(CellScenes, fourBuddhas) {
  expectGoals("builtin:statues,mesh=buddha.obj");
}
TEST(CellScenes, doors) {
  expectGoals("builtin:doors");
}
TEST(CellScenes, boxes) {
  expectGoals("builtin:boxes");
}
TEST(CellScenes, fence) {
  expectGoals("builtin:fence,gap=4");
}
// The goal is missed on these two: between pickets a pixel apart there is one sample at most, and what a lone teapot
// lacks is rims that every viewpoint sees at a grazing angle.
TEST(CellScenes, fenceWithGapsOfAPixel) {
  expectGoals("builtin:fence,gap=1", 0.30, 0.004);  // skins across the gaps cost the reference view 0.3 %
}
TEST(CellScenes, teapotBeforeNothing) {
  expectGoals("builtin:teapot", 0.40);
}

}  // namespace
}  // namespace ocelli
