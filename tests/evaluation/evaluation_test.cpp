#include "oc_core/evaluation/evaluation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/evaluation/evaluation_json.h"
#include "oc_core/evaluation/evaluation_table.h"
#include "oc_core/ocri/image_mesh.h"
#include "tests/ocri/test_scenes.h"
#include "tests/ranks/thread_ranks.h"

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

void expectPlaces(const nlohmann::ordered_json& json) {
  EXPECT_THAT(keysOf(json), ElementsAre("edges", "interior", "reference"));
}

TEST(Evaluation, jsonHasItsFields) {
  EvaluationOptions options = smallOptions();
  options.compareImages = true;
  options.offsets = {0, 0.5f, 1};
  options.offsetDirections = 2;
  size_t slicedTriangles = 0;
  options.slice = [&](const Mesh& mesh) { slicedTriangles += mesh.triangles.size(); };
  const auto figures = evaluate(test::boxBeforeWall(0.9f), choices({"di", "ddoc", "ddoc-constant"}), options);
  const auto json = nlohmann::ordered_json::parse(evaluationJson("builtin:x", options, figures));
  EXPECT_THAT(keysOf(json),
              ElementsAre("scene", "view", "size", "cell", "seed", "representations", "offsets", "runs", "complete"));
  EXPECT_EQ(json["scene"], "builtin:x");
  EXPECT_EQ(json["size"], nlohmann::ordered_json({90, 60}));
  EXPECT_NEAR(json["cell"]["side_radii"].get<double>(), 1.6, 1e-6);
  EXPECT_EQ(json["cell"]["shape"], "cube");
  EXPECT_EQ(json["cell"]["edge_views"], 1);
  EXPECT_EQ(json["view"]["eye"], nlohmann::ordered_json({0, 0, 10}));
  EXPECT_EQ(json["offsets"]["half_sides"], nlohmann::ordered_json({0.0, 0.5, 1.0}));
  EXPECT_EQ(json["offsets"]["directions"], 2);
  EXPECT_EQ(json["complete"], true);
  ASSERT_EQ(json["representations"].size(), 3u);
  size_t triangles = 0;
  for (const auto& row : json["representations"]) {
    EXPECT_THAT(keysOf(row), ElementsAre("name", "triangles", "samples", "build_ms", "mesh_ms", "slice_ms",
                                         "missing_strict", "missing_thick", "ratio_to_di", "wrong_front", "false_skins",
                                         "psnr_db", "ssim", "flip", "pixels", "bytes", "along_edges", "at_offsets"));
    EXPECT_TRUE(row["triangles"].is_number_unsigned());
    EXPECT_TRUE(row["samples"].is_number_unsigned());
    triangles += row["triangles"].get<size_t>();
    for (const char* time : {"build_ms", "mesh_ms", "slice_ms"}) {
      EXPECT_GE(row[time].get<double>(), 0) << time;
    }
    for (const char* measure : {"missing_strict", "missing_thick", "wrong_front", "false_skins", "flip", "ssim"}) {
      expectPlaces(row[measure]);
      for (const auto& value : row[measure]) {
        expectRatio(value);
      }
    }
    expectPlaces(row["psnr_db"]);
    EXPECT_THAT(keysOf(row["ratio_to_di"]), ElementsAre("strict", "thick"));
    EXPECT_EQ(row["pixels"], 90 * 60);
    EXPECT_GT(row["bytes"]["raw"].get<size_t>(), row["bytes"]["zstd"].get<size_t>());
    EXPECT_THAT(keysOf(row["at_offsets"]),
                ElementsAre("missing_strict", "missing_thick", "wrong_front", "false_skins"));
    for (const auto& curve : row["at_offsets"]) {
      EXPECT_EQ(curve.size(), 3u);
    }
    EXPECT_EQ(row["at_offsets"]["missing_strict"][0], row["missing_strict"]["reference"]) << "at a distance of 0";
  }
  EXPECT_EQ(triangles, slicedTriangles) << "each mesh was sliced, once";
  EXPECT_EQ(json["representations"][0]["name"], "di");
  EXPECT_EQ(json["representations"][0]["ratio_to_di"]["strict"], 1.0);
  EXPECT_EQ(json["representations"][0]["ratio_to_di"]["thick"], 1.0);
  EXPECT_LT(json["representations"][1]["ratio_to_di"]["strict"], 0.5) << "the ddoc is worth its name";
  EXPECT_LT(json["representations"][1]["flip"]["edges"], json["representations"][0]["flip"]["edges"]);
  EXPECT_THAT(evaluationTable(figures), HasSubstr("ddoc-constant"));
  EXPECT_THAT(evaluationTable(figures), HasSubstr("FLIP"));
}

TEST(Evaluation, jsonSaysWhichCellAndThatRowsAreMissing) {
  EvaluationOptions options = smallOptions();
  options.cell.shape = ViewCell::Shape::kSegment;
  options.cell.segmentDirection = {0, 1, 0};
  const auto json = nlohmann::json::parse(evaluationJson("x\xff", options, {}, false));
  EXPECT_EQ(json["cell"]["shape"], "segment");
  EXPECT_EQ(json["cell"]["segment_direction"], nlohmann::json({0.0, 1.0, 0.0}));
  EXPECT_EQ(json["complete"], false);
  EXPECT_EQ(json["representations"].size(), 0u);
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

/// A representation that is the mesh itself.
MakeRepresentation meshAlone(const Mesh& mesh) {
  return [&mesh](RepresentationTimes&) { return Representation{"mesh", {}, mesh}; };
}

EvaluationOptions fullOptions() {
  EvaluationOptions options = smallOptions();
  options.compareImages = true;
  options.offsets = {0, 0.3f, 1};
  options.offsetDirections = 3;
  return options;
}

TEST(Evaluator, theSceneItselfHasNoErrors) {
  const Mesh mesh = test::boxBeforeWall(0.9f);
  const EvaluationOptions options = fullOptions();
  const RepresentationFigures figures = Evaluator(mesh, options).measure("geometry", meshAlone(mesh));
  EXPECT_EQ(figures.samples, mesh.positions.size()) << "without images the vertices count";
  EXPECT_EQ(figures.pixels, 0u);
  EXPECT_EQ(figures.bytes.raw, storedSize(mesh).raw);
  ASSERT_EQ(figures.offsets.size(), 3u);
  for (const FrameErrors* errors : {&figures.edges, &figures.interior, &figures.reference, &figures.offsets[2]}) {
    EXPECT_GT(errors->truth, 0u);
    EXPECT_EQ(errors->strict + errors->wrongFront + errors->falseSkin, 0u);
    EXPECT_EQ(errors->meanFlip(), 0);
  }
  EXPECT_EQ(figures.edges.images, 20u);
  EXPECT_EQ(figures.strictRatioToDi, 0);
  const auto json = nlohmann::json::parse(evaluationJson("x", options, {figures}));
  EXPECT_TRUE(json["representations"][0]["psnr_db"]["edges"].is_null()) << "it is infinite";
  EXPECT_EQ(json["representations"][0]["flip"]["edges"], 0.0);
}

TEST(Evaluator, anEmptyMeshLacksEverything) {
  const Mesh mesh = test::boxBeforeWall(0.9f);
  const Mesh empty;
  const RepresentationFigures figures = Evaluator(mesh, fullOptions()).measure("empty", meshAlone(empty));
  EXPECT_EQ(figures.edges.strictRatio(), 1);
  EXPECT_EQ(figures.edges.frame, 0u);
  EXPECT_EQ(figures.edges.falseSkinRatio(), 0);
  EXPECT_GT(figures.edges.meanFlip(), 0.01);
  EXPECT_LT(figures.edges.meanPsnrDecibels(), 40);
}

// The view looks past the scene: the depth image says so, and what needs none has nothing to count.
TEST(Evaluator, aSceneThatIsNotSeenHasNoSamples) {
  Mesh mesh = test::wall(0, 0.2f);
  for (glm::vec3& p : mesh.positions) {
    p.x += 50;
  }
  EvaluationOptions options = fullOptions();
  Evaluator evaluator(mesh, options);
  EXPECT_THROW(evaluator.measure(cameraChoice("di")), InputError);
  const RepresentationFigures figures = evaluator.measure("mesh", meshAlone(mesh));
  EXPECT_EQ(figures.edges.truth, 0u);
  EXPECT_EQ(figures.edges.strictRatio(), 0);
  EXPECT_EQ(figures.strictRatioToDi, 0);
  EXPECT_EQ(figures.edges.meanSsim(), 1) << "black on black";
}

// A small closed box around a corner of the view cell: from in there one would see its inside.
TEST(Evaluator, refusesAViewpointInsideAnObject) {
  Mesh mesh = test::boxBeforeWall();
  append(mesh, makeBox(glm::vec3(0.1f)), glm::translate(glm::mat4(1), View{}.eye + glm::vec3(0.8f, 0.8f, 0.8f)));
  try {
    const Evaluator evaluator(mesh, smallOptions());
    FAIL() << "it was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("(0.8, 0.8, 10.8)"));
  }
  EvaluationOptions smaller = smallOptions();
  smaller.cell.sideRadii = 1;
  smaller.interiorViews = 0;
  EXPECT_NO_THROW(Evaluator(mesh, smaller));
}

TEST(Evaluator, aCellWithoutExtentMeasuresTheReferenceView) {
  EvaluationOptions options = fullOptions();
  options.cell.sideRadii = 0;
  const auto figures = evaluate(test::boxBeforeWall(0.9f), choices({"di"}), options)[0];
  EXPECT_EQ(figures.edges.strictRatio(), figures.reference.strictRatio());
  EXPECT_EQ(figures.interior.thickRatio(), figures.reference.thickRatio());
}

TEST(Evaluator, takesASinglePixel) {
  EvaluationOptions options = fullOptions();
  options.width = 1;
  options.height = 1;
  const auto figures = evaluate(test::boxBeforeWall(), choices({"di"}), options)[0];
  EXPECT_EQ(figures.reference.truth, 1u);
  EXPECT_EQ(figures.pixels, 1u);
  EXPECT_EQ(figures.reference.thick, 0u) << "it has no neighbours";
}

TEST(Evaluator, isTheSameForAnyNumberOfThreads) {
  const Mesh mesh = test::boxBeforeWall(0.9f);
  EvaluationOptions options = fullOptions();
  options.edgeViews = 2;
  const auto jsonWith = [&](int threads) {
    setThreadCount(threads);
    auto figures = evaluate(mesh, choices({"di", "ddoc"}), options);
    setThreadCount(0);
    for (RepresentationFigures& row : figures) {
      row.buildMilliseconds = row.meshMilliseconds = 0;
    }
    return evaluationJson("x", options, figures);
  };
  const std::string one = jsonWith(1);
  EXPECT_EQ(one, jsonWith(2));
  EXPECT_EQ(one, jsonWith(5));
}

TEST(Evaluator, measuresEachCellOfItsOwnShape) {
  const Mesh mesh = test::boxBeforeWall(0.9f);
  EvaluationOptions options = smallOptions();
  options.cell.shape = ViewCell::Shape::kSegment;
  options.cell.segmentDirection = {0, 0, 1};  // to and fro uncovers less than to the sides
  const auto along = evaluate(mesh, choices({"di"}), options)[0];
  options.cell.segmentDirection = {1, 0, 0};
  const auto across = evaluate(mesh, choices({"di"}), options)[0];
  options.cell.shape = ViewCell::Shape::kSphere;
  const auto sphere = evaluate(mesh, choices({"di"}), options)[0];
  EXPECT_LT(along.edges.strictRatio(), 0.5 * across.edges.strictRatio());
  EXPECT_GT(sphere.edges.truth, 9 * across.edges.truth) << "20 viewpoints to 2";
  EXPECT_GT(sphere.edges.strictRatio(), 0);
}

TEST(Evaluator, makesAndSlicesAsOftenAsToldAndTakesTheBest) {
  const Mesh mesh = test::boxBeforeWall(0.9f);
  EvaluationOptions options = smallOptions();
  options.runs = 3;
  int slices = 0;
  options.slice = [&](const Mesh&) { ++slices; };
  int made = 0;
  const std::vector<std::pair<double, double>> times{{7, 3}, {5, 9}, {6, 2}};
  int visits = 0;
  const RepresentationFigures figures =
      Evaluator(mesh, options)
          .measure(
              "mesh",
              [&](RepresentationTimes& taken) {
                taken.buildMilliseconds = times[static_cast<size_t>(made)].first;
                taken.meshMilliseconds = times[static_cast<size_t>(made)].second;
                ++made;
                return Representation{"mesh", {}, mesh};
              },
              {}, [&](const Mesh& visited) { visits += visited.triangles.size() == mesh.triangles.size(); });
  EXPECT_EQ(made, 3);
  EXPECT_EQ(slices, 3);
  EXPECT_EQ(visits, 1);
  EXPECT_EQ(figures.buildMilliseconds, 5);
  EXPECT_EQ(figures.meshMilliseconds, 2);
}

TEST(Evaluator, progressRunsFromZeroToOneAndMayThrow) {
  const Mesh mesh = test::boxBeforeWall(0.9f);
  Evaluator evaluator(mesh, fullOptions());
  std::mutex mutex;
  std::vector<double> fractions;
  evaluator.measure("mesh", meshAlone(mesh), [&](std::string_view stage, double fraction) {
    const std::scoped_lock lock(mutex);
    EXPECT_EQ(stage, "mesh");
    fractions.push_back(fraction);
  });
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_EQ(fractions.back(), 1);
  // 20 + 2 + 1 viewpoints, 3 directions at 2 distances: the distance of 0 is the reference again.
  EXPECT_EQ(fractions.size(), 2u + 20 + 2 + 1 + 6);
  struct Stop {};
  std::atomic<int> calls = 0;
  EXPECT_THROW(evaluator.measure("mesh", meshAlone(mesh),
                                 [&](std::string_view, double) {
                                   if (++calls == 10) {
                                     throw Stop{};
                                   }
                                 }),
               Stop);
}

TEST(Evaluator, exampleIsSeenFromTheLeft) {
  const Mesh mesh = test::boxBeforeWall(0.9f);
  const Evaluator evaluator(mesh, smallOptions());
  EXPECT_LT(glm::distance(evaluator.exampleView().eye, glm::vec3(-0.8f, 0, 10)), 1e-5f);
  const Evaluator::Example same = evaluator.example(mesh);
  EXPECT_TRUE(same.image == evaluator.exampleImage());
  EXPECT_FALSE(same.errors == same.image) << "dimmed";
  EXPECT_EQ(same.errors.width(), test::kWidth);
}

TEST(DefaultOffsets, runFromNoneToHalfASide) {
  const std::vector<float> offsets = defaultOffsets();
  EXPECT_EQ(offsets.front(), 0);
  EXPECT_EQ(offsets.back(), 1);
  EXPECT_TRUE(std::is_sorted(offsets.begin(), offsets.end()));
}

TEST(Evaluator, moreViewsOnEdgesAreMeasuredEachByItself) {
  const Mesh mesh = test::boxBeforeWall(0.9f);
  EvaluationOptions options = smallOptions();
  options.edgeViews = 2;
  const RepresentationFigures figures = evaluate(mesh, choices({"di"}), options)[0];
  const std::vector<View> views = options.cell.edgeViews(options.view, 2);
  ASSERT_EQ(figures.edgeViews.size(), 12u * 2 + 8);
  ASSERT_EQ(figures.edgeViews.size(), views.size());
  FrameErrors sum;
  for (size_t i = 0; i < views.size(); ++i) {
    // Measured alone, the same viewpoint misses the same.
    const PinholeCamera camera(views[i], test::kWidth, test::kHeight);
    const Mesh depthImage = imageMesh(buildDepthImage(test::smallCamera(), mesh));
    const MissingSamples alone =
        countMissing(compareFrames(camera, positionImage(camera, mesh), positionImage(camera, depthImage)));
    EXPECT_EQ(figures.edgeViews[i].strict, alone.strict) << i;
    EXPECT_EQ(figures.edgeViews[i].thick, alone.thick) << i;
    sum += figures.edgeViews[i];
  }
  EXPECT_EQ(sum.strict, figures.edges.strict);
  EXPECT_GT(sum.strict, 0u);
}

// One viewpoint on each edge is its midpoint: the figures are those of the default.
TEST(Evaluation, jsonHasTheErrorsAlongEachEdge) {
  const Mesh mesh = test::boxBeforeWall(0.9f);
  EvaluationOptions options = smallOptions();
  const auto plain = evaluate(mesh, choices({"di"}), options);
  const auto one = nlohmann::json::parse(evaluationJson("x", options, plain))["representations"][0];
  options.edgeViews = 3;
  const auto more = evaluate(mesh, choices({"di"}), options);
  const auto three = nlohmann::json::parse(evaluationJson("x", options, more))["representations"][0];
  ASSERT_EQ(one["along_edges"].size(), 12u);
  ASSERT_EQ(three["along_edges"].size(), 12u);
  for (size_t edge = 0; edge < 12; ++edge) {
    const auto& coarse = one["along_edges"][edge];
    const auto& fine = three["along_edges"][edge];
    EXPECT_EQ(coarse["from"], fine["from"]);
    ASSERT_EQ(coarse["missing_strict"].size(), 3u);
    ASSERT_EQ(fine["missing_strict"].size(), 5u);
    for (const char* measure : {"missing_strict", "missing_thick", "wrong_front", "false_skins"}) {
      for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(coarse[measure][i], fine[measure][2 * i]) << measure << " at corner, middle, corner of " << edge;
      }
    }
  }
  EXPECT_EQ(one["along_edges"][0]["from"], nlohmann::json({-1.0, -1.0, -1.0}));
  EXPECT_EQ(one["along_edges"][0]["to"], nlohmann::json({1.0, -1.0, -1.0}));
}

/// Times differ from run to run.
RepresentationFigures withoutTimes(RepresentationFigures figures) {
  figures.buildMilliseconds = 0;
  figures.meshMilliseconds = 0;
  figures.sliceMilliseconds = 0;
  return figures;
}

TEST(Evaluation, isTheSameForAnyNumberOfRanks) {
  const Mesh mesh = test::boxBeforeWall();
  EvaluationOptions options = smallOptions();
  options.compareImages = true;
  options.edgeViews = 2;
  options.offsets = {0, 0.5f, 1};
  const auto jsonOf = [&](std::vector<RepresentationFigures> rows) {
    std::transform(rows.begin(), rows.end(), rows.begin(), withoutTimes);
    return evaluationJson("scene", options, rows);
  };
  const std::vector<CameraChoice> cameras = choices({"di", "ddoc"});
  const std::string alone = jsonOf(evaluate(mesh, cameras, options));
  for (const int size : {2, 3, 8}) {
    test::runInRanks(size, [&](Ranks& ranks) {
      EvaluationOptions shared = options;
      shared.ranks = &ranks;
      EXPECT_EQ(jsonOf(evaluate(mesh, cameras, shared)), alone);
    });
  }
}

}  // namespace
}  // namespace ocelli
