#include "oc_core/evaluation/evaluation_work.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/evaluation/evaluation_json.h"
#include "tests/base/temporary_folder.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using ::testing::HasSubstr;

RepresentationFigures figuresOf(const std::string& name) {
  RepresentationFigures row;
  row.name = name;
  row.triangles = 12;
  row.samples = 9007199254740991;
  row.pixels = 3;
  row.bytes = {1000, 100};
  row.buildMilliseconds = 1.0 / 3;
  row.meshMilliseconds = 2;
  row.sliceMilliseconds = 0.1;
  row.edges.truth = 200;
  row.edges.strict = 50;
  row.edges.thick = 20;
  row.edges.wrongFront = 10;
  row.edges.frame = 190;
  row.edges.falseSkin = 4;
  row.edges.images = 3;
  row.edges.squaredError = 1.0 / 7;
  row.edges.ssim = -1.0 / 9;
  row.edges.flip = 1e-300;
  row.interior = row.edges;
  row.interior.truth = 7;
  row.reference.truth = 1;
  row.edgeViews = std::vector<FrameErrors>(20, row.edges);
  row.edgeViews[3].strict = 60;
  row.offsets = {row.edges, row.reference};
  row.strictRatioToDi = 0.3;
  row.thickRatioToDi = 0.1;
  return row;
}

std::string jsonOf(const RepresentationFigures& row) {
  return evaluationJson("x", {}, {row});
}

TEST(EvaluationWork, keepsFiguresToTheLastBit) {
  const test::TemporaryFolder folder;
  EvaluationWork written(folder / "x.work", "key");
  written.add("di", figuresOf("di"));
  written.add("ddoc", figuresOf("ddoc"));
  EvaluationWork read(folder / "x.work", "key");
  read.load();
  EXPECT_EQ(read.count(), 2u);
  ASSERT_TRUE(read.find("ddoc").has_value());
  EXPECT_EQ(jsonOf(*read.find("ddoc")), jsonOf(figuresOf("ddoc")));
  EXPECT_FALSE(read.find("other").has_value());
  ASSERT_EQ(read.find("di")->edgeViews.size(), 20u);
  EXPECT_EQ(read.find("di")->edgeViews[3].strict, 60u);
  // What the public JSON does not show.
  EXPECT_EQ(read.find("di")->edges.frame, 190u);
  EXPECT_EQ(read.find("di")->edges.flip, 1e-300);
}

TEST(EvaluationWork, addingACameraAgainReplacesIt) {
  const test::TemporaryFolder folder;
  EvaluationWork work(folder / "x.work", "key");
  work.add("di", figuresOf("old"));
  work.add("di", figuresOf("new"));
  EXPECT_EQ(work.count(), 1u);
  EXPECT_EQ(work.find("di")->name, "new");
}

TEST(EvaluationWork, refusesTheFileOfAnotherKey) {
  const test::TemporaryFolder folder;
  EvaluationWork(folder / "x.work", "one").add("di", figuresOf("di"));
  EvaluationWork other(folder / "x.work", "two");
  try {
    other.load();
    FAIL() << "it was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("another scene"));
    EXPECT_THAT(error.what(), HasSubstr("x.work"));
  }
  EXPECT_EQ(other.count(), 0u);
}

TEST(EvaluationWork, refusesBrokenFiles) {
  const test::TemporaryFolder folder;
  EvaluationWork(folder / "x.work", "key").add("di", figuresOf("di"));
  const std::string good = test::fileBytes(folder / "x.work");
  const nlohmann::json whole = nlohmann::json::parse(good);
  const auto without = [&](const std::string& pointer) {
    nlohmann::json json = whole;
    const nlohmann::json::json_pointer path(pointer);
    json[path.parent_pointer()].erase(path.back());
    return json.dump();
  };
  const auto with = [&](const std::string& pointer, const nlohmann::json& value) {
    nlohmann::json json = whole;
    json[nlohmann::json::json_pointer(pointer)] = value;
    return json.dump();
  };
  for (const std::string& bytes : {std::string(),
                                   std::string("{"),
                                   std::string("[]"),
                                   good.substr(0, good.size() / 2),
                                   without("/key"),
                                   without("/representations"),
                                   with("/format", 1),
                                   with("/format", 2),
                                   with("/format", 4),
                                   with("/more", 1),
                                   with("/representations", 3),
                                   with("/representations/0", 3),
                                   without("/representations/0/figures/edges/truth"),
                                   with("/representations/0/figures/edges/truth", -1),
                                   with("/representations/0/figures/edges/truth", "many"),
                                   with("/representations/0/figures/offsets", 1),
                                   with("/representations/0/figures/edge_views", 1),
                                   with("/representations/0/figures/edge_views/3/strict", -1),
                                   without("/representations/0/figures/edge_views"),
                                   with("/representations/0/figures/offsets/0", 1),
                                   with("/representations/0/figures/more", 1)}) {
    EvaluationWork work(folder.write("x.work", bytes), "key");
    EXPECT_THROW(work.load(), InputError) << bytes;
    EXPECT_EQ(work.count(), 0u);
  }
  EvaluationWork missing(folder / "no such file", "key");
  EXPECT_THROW(missing.load(), InputError);
}

TEST(EvaluationWork, leavesNoOtherFileAndRemovesItsOwn) {
  const test::TemporaryFolder folder;
  EvaluationWork work(folder / "x.work", "key");
  work.add("di", figuresOf("di"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  work.remove();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_NO_THROW(work.remove());
}

TEST(EvaluationWork, saysWhereItCannotWrite) {
  const test::TemporaryFolder folder;
  EvaluationWork work(folder / "none/x.work", "key");
  EXPECT_THROW(work.add("di", figuresOf("di")), WorkError);
}

TEST(EvaluationKey, changesWithAnythingThatFiguresDependOn) {
  const Mesh mesh = test::boxBeforeWall();
  EvaluationOptions options;
  options.width = 90;
  options.height = 60;
  std::set<std::string> keys{evaluationKey(mesh, options, "")};
  EXPECT_EQ(evaluationKey(mesh, options, ""), *keys.begin());
  size_t changes = 0;
  const auto expectNew = [&](const Mesh& scene, const EvaluationOptions& changed, const std::string& more) {
    keys.insert(evaluationKey(scene, changed, more));
    EXPECT_EQ(keys.size(), ++changes + 1) << "change " << changes;
  };
  expectNew(mesh, options, "more");
  Mesh moved = mesh;
  moved.positions.back().x += 1e-6f;
  expectNew(moved, options, "");
  Mesh painted = mesh;
  painted.colors.front().y += 1e-6f;
  expectNew(painted, options, "");
  Mesh turned = mesh;
  std::swap(turned.triangles[0], turned.triangles[1]);
  expectNew(turned, options, "");
  const auto changed = [&](const std::function<void(EvaluationOptions&)>& change) {
    EvaluationOptions other = options;
    change(other);
    expectNew(mesh, other, "");
  };
  changed([](auto& o) { o.view.eye.x = 0.1f; });
  changed([](auto& o) { o.width = 91; });
  changed([](auto& o) { o.height = 61; });
  changed([](auto& o) { o.cell.sideRadii = 1; });
  changed([](auto& o) { o.cell.shape = ViewCell::Shape::kSphere; });
  changed([](auto& o) { o.cell.segmentDirection.y = 1; });
  changed([](auto& o) { o.interiorViews = 1; });
  changed([](auto& o) { o.seed = 2; });
  changed([](auto& o) { o.compareImages = true; });
  changed([](auto& o) { o.offsets = {0.5f}; });
  changed([](auto& o) { o.offsetDirections = 1; });
  changed([](auto& o) { o.runs = 2; });
  changed([](auto& o) { o.slice = [](const Mesh&) {}; });
}

TEST(TextHash, tellsTextsApart) {
  EXPECT_EQ(textHash(""), "cbf29ce484222325") << "the offset basis of FNV-1a";
  EXPECT_EQ(textHash("a"), "af63dc4c8601ec8c") << "a published test vector of FNV-1a";
}

}  // namespace
}  // namespace ocelli
