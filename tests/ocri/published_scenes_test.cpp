// The figures that the depth discontinuity occlusion camera must reach on the scenes of section 3.5.5.7, at the size of
// the published measurements. The scenes come from the meshes in $OCELLI_DATA_DIR.
#include <gtest/gtest.h>

#include <cstdlib>

#include "oc_core/evaluation/evaluation_table.h"
#include "oc_core/scene/scene_source.h"

namespace ocelli {
namespace {

struct Goal {
  const char* scene;
  double strictRatio;
  double thickRatio;
};

void expectFigures(const Goal& goal) {
  if (std::getenv("OCELLI_DATA_DIR") == nullptr) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set: the meshes of the published scenes are not at hand";
  }
  EvaluationOptions options;
  options.width = kDefaultWidth;
  options.height = kDefaultHeight;
  options.interiorViews = 4;
  const auto figures = evaluate(loadScene(goal.scene),
                                {cameraChoice("di"), cameraChoice("ddoc"), cameraChoice("ddoc-constant")}, options);
  const RepresentationFigures& di = figures[0];
  const RepresentationFigures& ddoc = figures[1];
  EXPECT_LE(ddoc.strictRatioToDi, goal.strictRatio);
  EXPECT_LE(ddoc.thickRatioToDi, goal.thickRatio);
  EXPECT_LE(ddoc.triangles, di.triangles);
  EXPECT_LE(di.reference.strictRatio(), 0.0005);
  EXPECT_LE(ddoc.reference.strictRatio(), 0.005);
  EXPECT_LT(ddoc.interior.strictRatio(), di.interior.strictRatio());
  // The text's own construction helps as well, though less.
  EXPECT_LT(figures[2].strictRatioToDi, 1);
  EXPECT_LT(ddoc.strictRatioToDi, figures[2].strictRatioToDi);
  std::printf("%s\n%s", goal.scene, evaluationTable(figures).c_str());
}

TEST(PublishedScenes, bunny) {
  expectFigures({"builtin:room,mesh=bunny.obj", 0.25, 0.06});
}

TEST(PublishedScenes, fourBuddhas) {
  expectFigures({"builtin:statues,mesh=buddha.obj", 0.45, 0.18});
}

}  // namespace
}  // namespace ocelli
