#include "oc_core/evaluation/evaluation_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/ocri/image_mesh.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

EvaluationOptions smallOptions() {
  EvaluationOptions options;
  options.width = test::kWidth;
  options.height = test::kHeight;
  options.interiorViews = 2;
  return options;
}

std::vector<CameraChoice> choices(const std::vector<std::string>& names) {
  std::vector<CameraChoice> chosen;
  for (const std::string& name : names) {
    chosen.push_back(cameraChoice(name));
  }
  return chosen;
}

std::vector<std::string> keysOf(const nlohmann::ordered_json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) {
    keys.push_back(key);
  }
  return keys;
}

void expectRatio(const nlohmann::ordered_json& value) {
  ASSERT_TRUE(value.is_number());
  EXPECT_GE(value.get<double>(), 0);
  EXPECT_LE(value.get<double>(), 1);
}

TEST(Evaluation, jsonHasItsFields) {
  EvaluationOptions options = smallOptions();
  size_t slicedTriangles = 0;
  options.slice = [&](const Mesh& mesh) { slicedTriangles += mesh.triangles.size(); };
  const auto figures = evaluate(test::boxBeforeWall(0.9f), choices({"di", "ddoc", "ddoc-constant"}), options);
  const auto json = nlohmann::ordered_json::parse(evaluationJson("builtin:x", options, figures));
  EXPECT_THAT(keysOf(json), ElementsAre("scene", "view", "size", "cell", "seed", "representations"));
  EXPECT_EQ(json["scene"], "builtin:x");
  EXPECT_EQ(json["size"], nlohmann::ordered_json({90, 60}));
  EXPECT_NEAR(json["cell"]["side_radii"].get<double>(), 1.6, 1e-6);
  EXPECT_EQ(json["view"]["eye"], nlohmann::ordered_json({0, 0, 10}));
  ASSERT_EQ(json["representations"].size(), 3u);
  size_t triangles = 0;
  for (const auto& row : json["representations"]) {
    EXPECT_THAT(keysOf(row), ElementsAre("name", "triangles", "samples", "build_ms", "mesh_ms", "slice_ms",
                                         "missing_strict", "missing_thick", "ratio_to_di"));
    EXPECT_TRUE(row["triangles"].is_number_unsigned());
    EXPECT_TRUE(row["samples"].is_number_unsigned());
    triangles += row["triangles"].get<size_t>();
    for (const char* time : {"build_ms", "mesh_ms", "slice_ms"}) {
      EXPECT_GE(row[time].get<double>(), 0) << time;
    }
    for (const char* measure : {"missing_strict", "missing_thick"}) {
      EXPECT_THAT(keysOf(row[measure]), ElementsAre("edges", "interior", "reference"));
      for (const auto& value : row[measure]) {
        expectRatio(value);
      }
    }
    EXPECT_THAT(keysOf(row["ratio_to_di"]), ElementsAre("strict", "thick"));
  }
  EXPECT_EQ(triangles, slicedTriangles) << "each mesh was sliced, once";
  EXPECT_EQ(json["representations"][0]["name"], "di");
  EXPECT_EQ(json["representations"][0]["ratio_to_di"]["strict"], 1.0);
  EXPECT_EQ(json["representations"][0]["ratio_to_di"]["thick"], 1.0);
  EXPECT_LT(json["representations"][1]["ratio_to_di"]["strict"], 0.5) << "the ddoc is worth its name";
  EXPECT_THAT(evaluationTable(figures), HasSubstr("ddoc-constant"));
}

TEST(Evaluation, withoutASlicerItsTimeIsNull) {
  const EvaluationOptions options = smallOptions();
  const auto figures = evaluate(test::boxBeforeWall(), choices({"di"}), options);
  EXPECT_TRUE(nlohmann::json::parse(evaluationJson("x", options, figures))["representations"][0]["slice_ms"].is_null());
}

TEST(Evaluation, ratiosDoNotNeedTheDepthImageAmongTheRows) {
  const EvaluationOptions options = smallOptions();
  const Mesh mesh = test::boxBeforeWall();
  const auto alone = evaluate(mesh, choices({"ddoc"}), options);
  const auto both = evaluate(mesh, choices({"ddoc", "di"}), options);
  EXPECT_EQ(alone[0].strictRatioToDi, both[0].strictRatioToDi);
  EXPECT_EQ(alone[0].thickRatioToDi, both[0].thickRatioToDi);
  EXPECT_EQ(both[1].strictRatioToDi, 1);
  EXPECT_EQ(both[1].name, "di");
}

TEST(Evaluation, countsWhatTheMeshesHold) {
  const Mesh mesh = test::boxBeforeWall();
  const auto figures = evaluate(mesh, choices({"di"}), smallOptions());
  const ReferenceImage image = buildDepthImage(test::smallCamera(), mesh);
  EXPECT_EQ(figures[0].samples, image.sampleCount());
  EXPECT_EQ(figures[0].triangles, imageMesh(image).triangles.size());
  const size_t pixels = static_cast<size_t>(test::kWidth) * test::kHeight;
  EXPECT_EQ(figures[0].edges.truth, 20 * pixels) << "the wall fills the image of each of the 20 viewpoints";
  EXPECT_EQ(figures[0].interior.truth, 2 * pixels);
  EXPECT_EQ(figures[0].reference.truth, pixels);
  EXPECT_LE(figures[0].reference.strictRatio(), 0.0005) << "the depth image lacks nothing that it sees";
}

}  // namespace
}  // namespace ocelli
