#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/render/identity_image.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_graph.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

using test::press;
using test::release;

constexpr TrialScreen kFindScreen{640, 480, 60};

/// Where the object shows on the screen, if it does: the pixel of it that is nearest to their mean.
std::optional<glm::dvec2> seenAt(const TrialRun& run) {
  const TrialLayout layout = run.layout();
  Mesh mesh = layout.scene->mesh();
  layout.scene->moveObjects(mesh, layout.objectOffsets);
  const TrialLayout::View& view = layout.views.front();
  const Image<uint32_t> drawn = std::visit(
      [&](const auto& camera) { return identityImage(rasterize(camera, mesh), layout.scene->objectOfTriangle()); },
      view.camera);
  const std::vector<ObjectSighting> sights = sightings(drawn);
  if (sights.empty()) {
    return std::nullopt;
  }
  return sights.front().centroid + glm::dvec2(view.place.left, view.place.top);
}

double measure(const TrialOutcome& outcome, const std::string& name) {
  for (const auto& [each, value] : outcome.measures) {
    if (each == name) {
      return value;
    }
  }
  ADD_FAILURE() << "no measure " << name;
  return 0;
}

std::string placeNameOf(const MazeCell& cell) {
  return fmt::format("row {}, column {}", cell.row, cell.column);
}

/// Moves the pointer with Shift and the arrows.
void pointByKeys(TrialRun& run, const glm::dvec2& to) {
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec2 by = to - *run.layout().pointer;
    if (std::abs(by.x) < 2 && std::abs(by.y) < 2) {
      return;
    }
    const bool across = std::abs(by.x) >= 2;
    const Key key = across ? (by.x > 0 ? Key::kRight : Key::kLeft) : (by.y > 0 ? Key::kDown : Key::kUp);
    run.handle(press(key, true));
    run.advance();
    run.handle(release(key));
  }
  FAIL() << "the pointer does not arrive";
}

const std::string kFromTheWest = R"({"maze": "small", "start": {"row": 2, "column": 0, "heading": "east"}, )";

TEST(FindTask, keysAloneAreEnough) {
  const auto block = test::readBlock("find", kFromTheWest + R"("cases": [{"row": 2, "column": 4}]})");
  const auto run = block->start(test::planOf("find", 0, TrialView::kReference), kFindScreen);
  run->handle(press(Key::kW));
  for (int i = 0; i < 240; ++i) {
    run->advance();
  }
  run->handle(release(Key::kW));
  const auto at = seenAt(*run);
  ASSERT_TRUE(at.has_value());
  pointByKeys(*run, *at);
  run->handle(press(Key::kSpace));
  ASSERT_TRUE(run->outcome().has_value());
  const TrialOutcome outcome = *run->outcome();
  EXPECT_TRUE(outcome.correct);
  EXPECT_FALSE(outcome.censored);
  EXPECT_EQ(outcome.answer, "object at row 2, column 4");
  EXPECT_EQ(outcome.expected, outcome.answer);
  EXPECT_GT(outcome.responseTicks, 240);
  EXPECT_NEAR(measure(outcome, "path_length_m"), 3, 1e-9);
  EXPECT_EQ(measure(outcome, "turned_degrees"), 0);
  EXPECT_EQ(measure(outcome, "collisions"), 0);
  EXPECT_EQ(measure(outcome, "wrong_clicks"), 0);
}

TEST(FindTask, wrongClicksAreCounted) {
  const auto block =
      test::readBlock("find", kFromTheWest + R"("limit_seconds": 2, "cases": [{"row": 2, "column": 4}]})");
  const auto run = block->start(test::planOf("find", 0, TrialView::kReference), kFindScreen);
  run->handle(test::moveTo({600, 100}));
  for (int i = 0; i < 3; ++i) {
    run->handle(test::button(PointerButton::kLeft, true));
    run->handle(test::button(PointerButton::kLeft, false));
  }
  EXPECT_FALSE(run->outcome().has_value());
  for (int i = 0; i < 480; ++i) {
    EXPECT_FALSE(run->outcome().has_value());
    run->advance();
  }
  ASSERT_TRUE(run->outcome().has_value());
  EXPECT_TRUE(run->outcome()->censored);
  EXPECT_EQ(run->outcome()->responseTicks, 480);
  EXPECT_EQ(measure(*run->outcome(), "wrong_clicks"), 3);
}

TEST(FindTask, theGraphCameraShowsWhatThePinholeHides) {
  // In the side way to the north, two crossings ahead.
  const auto block = test::readBlock("find", kFromTheWest + R"("cases": [{"row": 1, "column": 3}]})");
  const auto ahead = [&](TrialView view) {
    auto run = block->start(test::planOf("find", 0, view), kFindScreen);
    run->handle(press(Key::kW));
    for (int i = 0; i < 150; ++i) {
      run->advance();
    }
    run->handle(release(Key::kW));
    return run;
  };
  const auto pinhole = ahead(TrialView::kReference);
  const auto graph = ahead(TrialView::kOther);
  EXPECT_FALSE(seenAt(*pinhole).has_value());
  const auto at = seenAt(*graph);
  ASSERT_TRUE(at.has_value());
  for (TrialRun* run : {pinhole.get(), graph.get()}) {
    run->handle(test::moveTo(*at));
    run->handle(test::button(PointerButton::kLeft, true));
  }
  EXPECT_TRUE(graph->outcome().has_value());
  EXPECT_FALSE(pinhole->outcome().has_value());
}

TEST(FindTask, movingObjectsAreFoundWhereTheyAre) {
  const auto block = test::readBlock(
      "find", kFromTheWest + R"("moving": {"meters_per_second": 1.5}, "cases": [{"row": 2, "column": 4}]})");
  EXPECT_TRUE(block->caseInfo(0).moving);
  size_t found = 0;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const auto run = block->start(test::planOf("find", 0, TrialView::kReference, seed), kFindScreen);
    const glm::dvec2 first = seenAt(*run).value_or(glm::dvec2(0));
    for (int i = 0; i < 200; ++i) {
      run->advance();
    }
    const auto at = seenAt(*run);
    if (!at) {
      continue;
    }
    EXPECT_GT(glm::distance(first, *at), 3);
    run->handle(test::moveTo(*at));
    run->handle(test::button(PointerButton::kLeft, true));
    found += run->outcome().has_value() ? 1 : 0;
  }
  EXPECT_GE(found, 1u);
}

TEST(FindTask, placesAreDrawnFromBandsOfDistanceAlikeForAllViewsAndEachOnce) {
  const auto block = test::readBlock("find", kFromTheWest + R"("distance_bands": 2, "cases": [
      {"label": "a", "distance_band": 1}, {"label": "b", "distance_band": 2}, {"label": "c", "distance_band": 1}]})");
  const Maze maze = test::studyMaze();
  std::set<std::string> ofA;
  std::vector<int> near;
  std::vector<int> far;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const auto cellOf = [&](int index) {
      const TrialPlan plan = test::planOf("find", index, TrialView::kReference, seed);
      const auto run = block->start(plan, kFindScreen);
      const TrialLayout layout = run->layout();
      const MazeCell cell =
          *maze.cellAt(layout.scene->maze().centerOf(layout.scene->maze().landmarks[0].cell) + layout.objectOffsets[0]);
      EXPECT_EQ(block->answerOf(plan), "object at " + placeNameOf(cell));
      EXPECT_FALSE(seenAt(*run).has_value()) << nameOf(cell);
      TrialPlan other = plan;
      other.view = TrialView::kOther;
      EXPECT_EQ(block->answerOf(other), block->answerOf(plan));
      EXPECT_FALSE(seenAt(*block->start(other, kFindScreen)).has_value()) << nameOf(cell);
      return cell;
    };
    const MazeCell a = cellOf(0);
    ofA.insert(nameOf(a));
    EXPECT_NE(a, cellOf(2));
    near.push_back(*maze.shortestSteps({2, 0}, a));
    far.push_back(*maze.shortestSteps({2, 0}, cellOf(1)));
  }
  EXPECT_GT(ofA.size(), 1u);
  EXPECT_LE(*std::max_element(near.begin(), near.end()), *std::min_element(far.begin(), far.end()));
}

TEST(FindTask, theOutcomeTellsWherePlacesThatWereDrawnAre) {
  const auto drawn = test::readBlock(
      "find", kFromTheWest + R"("limit_seconds": 1, "distance_bands": 1, "cases": [{"distance_band": 1}])"
                             "}");
  const auto named = test::readBlock("find", kFromTheWest + R"("limit_seconds": 1, "cases": [{"row": 2, "column": 4}])"
                                                            "}");
  for (const auto& [block, isDrawn] : {std::pair(drawn, true), std::pair(named, false)}) {
    const TrialPlan plan = test::planOf("find", 0, TrialView::kReference, 7);
    const auto run = block->start(plan, kFindScreen);
    while (!run->outcome()) {
      run->advance();
    }
    const std::map<std::string, double> measures = run->outcome()->measures;
    ASSERT_EQ(measures.contains("object_row"), isDrawn);
    if (isDrawn) {
      const MazeCell cell{static_cast<int>(measures.at("object_row")), static_cast<int>(measures.at("object_column"))};
      EXPECT_EQ(block->answerOf(plan), "object at " + placeNameOf(cell));
    }
  }
}

TEST(FindTask, namedCellsAreNotDrawn) {
  const std::string drawn = R"("distance_bands": 1, "cases": [{"distance_band": 1}])";
  const auto free = test::readBlock("find", kFromTheWest + drawn + "}");
  std::map<std::string, int> cells;
  for (uint64_t seed = 1; seed <= 400; ++seed) {
    ++cells[free->answerOf(test::planOf("find", 0, TrialView::kReference, seed))];
  }
  ASSERT_GT(cells.size(), 3u);
  // "object at row 0, column 5"
  const std::string& one = cells.begin()->first;
  const std::string named =
      fmt::format(R"("practice_cases": [{{"row": {}, "column": {}}}])", one.substr(14, 1), one.substr(one.size() - 1));
  const auto block = test::readBlock("find", kFromTheWest + drawn + ", " + named + "}");
  for (uint64_t seed = 1; seed <= 400; ++seed) {
    EXPECT_NE(block->answerOf(test::planOf("find", 0, TrialView::kReference, seed)), one);
  }
}

TEST(FindTask, saysWhatIsWrong) {
  const auto error = [](const std::string& rest) {
    return test::readError("find", R"({"maze": "small", )" + rest + "}");
  };
  const auto expect = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  expect(test::readError("find", R"({"maze": "large", "cases": [{"row": 0, "column": 0}]})"), "small");
  expect(error(R"("cases": [])"), "1 to 1000 cases");
  expect(error(R"("cases": [{"row": 5, "column": 0}])"), "row");
  expect(error(R"("cases": [{"row": 0, "column": 0, "east": 0.45}])"), "reaches into a wall");
  expect(error(R"("cases": [{"label": "a", "row": 0, "column": 0}, {"label": "a", "row": 0, "column": 1}])"), "label");
  expect(error(R"("cases": [{"row": 0, "column": 0, "colour": 1}])"), "colour");
  expect(error(R"("cases": [{"row": 0, "column": 0, "distance_band": 1}])"), "give one or the other");
  expect(error(R"("distance_bands": 2, "cases": [{"distance_band": 3}])"), "distance_band");
  expect(error(R"("distance_bands": 12, "cases": [{"distance_band": 1}, {"distance_band": 1}, {"distance_band": 1},
                  {"distance_band": 1}])"),
         "has 4 cases in band 1 of 12");
  expect(error(R"("cases": [{"distance_band": 1, "east": 0.45}])"), "reaches into a wall");
  expect(error(R"("object": {"shape": "arch"}, "cases": [{"row": 0, "column": 0}])"), "arch");
  expect(error(R"("object": {"color": "red"}, "cases": [{"row": 0, "column": 0}])"), "vermilion");
  expect(error(R"("limit_seconds": 0, "cases": [{"row": 0, "column": 0}])"), "limit_seconds");
  expect(error(R"("moving": {"meters_per_second": 0}, "cases": [{"row": 0, "column": 0}])"), "meters_per_second");
  expect(error(R"("start": {"row": 0, "column": 9, "heading": "east"}, "cases": [{"row": 0, "column": 0}])"), "column");
  TaskSetting setting = test::studySetting();
  setting.controls.bodyRadiusMeters = 1.34;
  const std::string block = R"({"maze": "small", "cases": [{"row": 0, "column": 0}]})";
  expect(test::readError("find", block, setting), "body_radius_meters");
  setting.controls = {};
  setting.controls.eyeHeightMeters = 3;
  expect(test::readError("find", block, setting), "eye_height_meters");
  EXPECT_EQ(test::readError("find", block), "");
}

}  // namespace
}  // namespace ocelli
