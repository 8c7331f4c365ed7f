#include "oc_core/evaluation/viewers_evaluation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/ocri/union_mesh.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

EvaluationOptions smallOptions() {
  EvaluationOptions options;
  options.width = test::kWidth;
  options.height = test::kHeight;
  options.interiorViews = 2;
  return options;
}

TEST(ViewersEvaluation, oneViewerHasHisOwnMesh) {
  const ViewersFigures figures =
      evaluateViewers(test::boxBeforeWall(0.9f), cameraChoice("ddoc"), {View{}}, smallOptions());
  ASSERT_EQ(figures.viewers.size(), 1u);
  EXPECT_EQ(figures.viewers[0].own.triangles, figures.triangles);
  EXPECT_EQ(figures.viewers[0].own.edges.strict, figures.viewers[0].merged.edges.strict);
  EXPECT_EQ(figures.samples, figures.viewers[0].samples.kept);
}

// Alone, the figures are those of an evaluation from his view.
TEST(ViewersEvaluation, eachViewerIsMeasuredOverHisOwnCell) {
  const Mesh scene = test::boxBeforeWall(0.9f);
  const std::vector<View> views = viewsAround(View{}, 2);
  const ViewersFigures figures = evaluateViewers(scene, cameraChoice("di"), views, smallOptions());
  EvaluationOptions behind = smallOptions();
  behind.view = views[1];
  const RepresentationFigures alone = evaluate(scene, {cameraChoice("di")}, behind).front();
  EXPECT_EQ(figures.viewers[1].own.edges.strict, alone.edges.strict);
  EXPECT_EQ(figures.viewers[1].own.interior.truth, alone.interior.truth);
  EXPECT_EQ(figures.viewers[1].view, views[1]);
}

// Seen from aside, the squares of grazing surfaces stand out: of a union of viewers they are drawn in, so less is
// false. What is missing stays within a tenth of a percent of what each viewer's own mesh lacks, which counts seams, or
// is less.
TEST(ViewersEvaluation, viewersShowEachOtherLittleThatIsFalse) {
  const Mesh scene = loadScene("builtin:room", {});
  EvaluationOptions options = smallOptions();
  options.interiorViews = 0;
  options.width = 180;
  options.height = 120;
  const std::vector<View> views = viewsAround(View{}, 3);
  const ViewersFigures figures = evaluateViewers(scene, cameraChoice("di"), views, options);
  std::vector<ReferenceImages> images;
  for (const View& view : views) {
    images.push_back(buildReferenceImages(cameraChoice("di"), {view, options.width, options.height}, scene));
  }
  Representation asForOne{"union", mergeViewers(std::move(images)).images, {}};
  for (ReferenceImage& image : asForOne.images) {
    image.seenFromAside = false;
  }
  asForOne.mesh = unionMesh(asForOne.images);
  for (const ViewerFigures& viewer : figures.viewers) {
    options.view = viewer.view;
    Evaluator evaluator(scene, options);
    const FrameErrors wholeSquares = evaluator.measure("union", [&](RepresentationTimes&) { return asForOne; }).edges;
    EXPECT_LT(viewer.merged.edges.falseSkinRatio(), wholeSquares.falseSkinRatio());
    EXPECT_LT(viewer.merged.edges.falseSkinRatio(), 0.005);
    EXPECT_LE(viewer.merged.edges.strict - viewer.merged.edges.wrongFront, viewer.own.edges.strict);
    EXPECT_LT(viewer.merged.edges.wrongFrontRatio(), 0.01);
  }
}

TEST(ViewersEvaluation, reportsNameEveryViewer) {
  const ViewersFigures figures =
      evaluateViewers(test::boxBeforeWall(0.9f), cameraChoice("di"), viewsAround(View{}, 2), smallOptions());
  const std::string table = viewersTable(figures);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5);
  EXPECT_THAT(table, testing::HasSubstr("2 viewers, di"));
  ViewersFigures one = figures;
  one.viewers.pop_back();
  EXPECT_THAT(viewersTable(one), testing::StartsWith("1 viewer, di"));
  const auto json = nlohmann::json::parse(viewersJson("a scene", smallOptions(), figures));
  EXPECT_EQ(json["triangles"], figures.triangles);
  ASSERT_EQ(json["viewers"].size(), 2u);
  const nlohmann::json& second = json["viewers"][1];
  EXPECT_EQ(second["samples_kept"], figures.viewers[1].samples.kept);
  EXPECT_NEAR(second["view"]["eye"][2].get<double>(), -10, 1e-5);
  for (const char* mesh : {"own", "merged"}) {
    for (const char* figure : {"missing_strict", "missing_thick", "wrong_front", "false_skins"}) {
      for (const char* place : {"edges", "interior", "reference"}) {
        EXPECT_TRUE(second[mesh][figure][place].is_number());
      }
    }
  }
}

}  // namespace
}  // namespace ocelli
