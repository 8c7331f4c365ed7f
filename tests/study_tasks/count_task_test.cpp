#include <gtest/gtest.h>

#include <set>

#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

using test::press;

constexpr TrialScreen kScreen{800, 600, 75};
const std::string kPinholes =
    R"("pinholes": {"rows": 1, "columns": 1, "views": [{"row": 2, "column": 0, "heading": "east"}]})";

std::shared_ptr<const TaskBlock> block(const std::string& cases, const std::string& more = "") {
  return test::readBlock("count", R"({"maze": "small", )" + kPinholes + more + R"(, "cases": )" + cases + "}");
}

/// With a scene that has been shown and is hidden.
std::unique_ptr<TrialRun> hidden(const TaskBlock& of, int caseIndex = 0) {
  auto run = of.start(test::planOf("count", caseIndex, TrialView::kOther), kScreen);
  int64_t tick = 0;
  for (; !run->layout().views.empty(); tick += 4) {
    run->frameShown(tick);
  }
  run->frameShown(tick);
  return run;
}

TEST(CountTask, objectsStandInPlacesOfTheirOwnWithTheColoursAskedFor) {
  const auto of = block(R"([{"objects": 7, "exposure_seconds": 1},
                            {"objects": 5, "exposure_seconds": 1, "duplicate_colors": true}])");
  std::set<std::vector<MazeCell>> placements;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    for (int i = 0; i < 2; ++i) {
      const auto run = of->start(test::planOf("count", i, TrialView::kReference, seed), kScreen);
      const std::vector<Landmark> objects = run->layout().scene->maze().landmarks;
      std::vector<MazeCell> cells;
      std::set<LandmarkColor> colors;
      for (const Landmark& object : objects) {
        EXPECT_NE(object.cell, (MazeCell{4, 3}));  // the entrance
        EXPECT_NE(object.color, LandmarkColor::kIvory);
        cells.push_back(object.cell);
        colors.insert(object.color);
      }
      EXPECT_EQ(objects.size(), i == 0 ? 7u : 5u);
      EXPECT_EQ(std::set<MazeCell>(cells.begin(), cells.end()).size(), cells.size());
      EXPECT_TRUE(i == 0 ? colors.size() == 7 : colors.size() < 5) << colors.size();
      placements.insert(cells);
    }
  }
  EXPECT_GT(placements.size(), 78u);
}

TEST(CountTask, bothViewsShowTheSameItem) {
  const auto of = block(R"([{"objects": 6, "exposure_seconds": 1}])");
  const auto pinhole = of->start(test::planOf("count", 0, TrialView::kReference), kScreen);
  const auto graph = of->start(test::planOf("count", 0, TrialView::kOther), kScreen);
  EXPECT_EQ(pinhole->layout().scene->maze(), graph->layout().scene->maze());
  EXPECT_TRUE(std::holds_alternative<PinholeCamera>(pinhole->layout().views[0].camera));
  EXPECT_TRUE(std::holds_alternative<GraphCamera>(graph->layout().views[0].camera));
}

/// A trial of half a second whose frames come `ticks` of 1/240 s apart: how many show the scene.
int framesShown(TrialRun& run, int64_t ticks) {
  int frames = 0;
  int64_t tick = 0;
  for (; !run.layout().views.empty(); ++frames, tick += ticks) {
    run.handle(press(Key::k4));  // too early
    run.frameShown(tick);
    for (int64_t i = 0; i < ticks; ++i) {
      run.advance();
    }
  }
  run.handle(press(Key::k4));
  EXPECT_FALSE(run.outcome().has_value()) << "the last frame of the scene is still on the screen";
  run.frameShown(tick);  // the first without it
  return frames;
}

TEST(CountTask, theExposureEndsByTheClock) {
  const auto of = block(R"([{"objects": 4, "exposure_seconds": 0.5}])");
  // On a screen of 80 Hz whose frames take 1, 2, 10 and 30 times their interval: 120 ticks are half a second.
  struct Expected {
    int64_t ticks;
    int frames;
    int64_t shownTicks;
  };
  for (const Expected& expected : {Expected{3, 40, 120}, {6, 20, 120}, {30, 4, 120}, {90, 3, 270}}) {
    const auto run = of->start(test::planOf("count", 0, TrialView::kOther), {800, 600, 80});
    EXPECT_EQ(framesShown(*run, expected.ticks), expected.frames);
    EXPECT_EQ(run->layout().choices.size(), 4u);
    for (int i = 0; i < 120; ++i) {
      run->advance();
    }
    run->handle(press(Key::k4));
    ASSERT_TRUE(run->outcome().has_value());
    EXPECT_TRUE(run->outcome()->correct);
    EXPECT_EQ(run->outcome()->exposureFrames, expected.frames);
    EXPECT_EQ(run->outcome()->exposureTicks, expected.shownTicks);
    EXPECT_EQ(run->outcome()->responseTicks, 120);
  }
}

TEST(CountTask, theExposureOfOlderDatabasesIsCountedInFrames) {
  const auto of = block(R"([{"objects": 4, "exposure_seconds": 0.5}])");
  TrialPlan plan = test::planOf("count", 0, TrialView::kOther);
  plan.exposure = ExposureRule::kFrames;
  for (const int64_t ticks : {1, 3, 50}) {
    const auto run = of->start(plan, kScreen);
    EXPECT_EQ(framesShown(*run, ticks), 38) << "37.5 of 75 a second";
    run->handle(press(Key::k4));
    ASSERT_TRUE(run->outcome().has_value());
    EXPECT_EQ(run->outcome()->exposureFrames, 38);
    EXPECT_FALSE(run->outcome()->exposureTicks.has_value());
  }
}

TEST(CountTask, isAnsweredByDigitArrowsOrClick) {
  const auto of = block(R"([{"objects": 6, "exposure_seconds": 0.1}])");
  const auto digit = hidden(*of);
  digit->handle(press(Key::k8));  // no answer
  EXPECT_FALSE(digit->outcome().has_value());
  digit->handle(press(Key::k5));
  EXPECT_EQ(digit->outcome()->answer, "5");
  EXPECT_EQ(digit->outcome()->expected, "6");
  EXPECT_FALSE(digit->outcome()->correct);
  EXPECT_FALSE(digit->outcome()->censored);
  EXPECT_EQ(digit->outcome()->measures, (std::map<std::string, double>{{"count_error", -1}}));

  const auto arrows = hidden(*of);
  arrows->handle(press(Key::kEnter));  // nothing is marked
  EXPECT_FALSE(arrows->outcome().has_value());
  for (const Key key : {Key::kRight, Key::kRight, Key::kRight, Key::kRight, Key::kRight, Key::kLeft}) {
    arrows->handle(press(key));
  }
  EXPECT_TRUE(arrows->layout().choices[2].chosen);
  EXPECT_FALSE(arrows->layout().choices[3].chosen);
  arrows->handle(press(Key::kEnter));
  EXPECT_TRUE(arrows->outcome()->correct);

  const auto click = hidden(*of);
  click->handle(test::moveTo(click->layout().choices[2].place.center()));
  click->handle(test::button(PointerButton::kLeft, true));
  EXPECT_TRUE(click->outcome()->correct);
}

TEST(CountTask, objectsThatMoveStayInTheMaze) {
  const auto of = block(R"([{"objects": 7, "exposure_seconds": 20}])", R"(, "moving": {"meters_per_second": 3})");
  const auto run = of->start(test::planOf("count", 0, TrialView::kOther), kScreen);
  const Maze maze = run->layout().scene->maze();
  double farthest = 0;
  for (int i = 0; i < 4000; ++i) {
    run->advance();
    const std::vector<glm::vec3> offsets = run->layout().objectOffsets;
    ASSERT_EQ(offsets.size(), 7u);
    for (size_t k = 0; k < offsets.size(); ++k) {
      const glm::vec3 place = maze.centerOf(maze.landmarks[k].cell) + offsets[k];
      ASSERT_TRUE(maze.cellAt(place).has_value());
      ASSERT_FALSE(maze.isInWall(place));
      farthest = std::max(farthest, static_cast<double>(glm::length(offsets[k])));
    }
  }
  EXPECT_GT(farthest, 5);
}

TEST(CountTask, saysWhatIsWrong) {
  const auto expect = [](const std::string& fields, const std::string& part) {
    const std::string text = test::readError("count", R"({"maze": "small", )" + fields + "}");
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const std::string cases = R"(, "cases": [{"objects": 4, "exposure_seconds": 1}])";
  expect(R"("cases": [{"objects": 4, "exposure_seconds": 1}])", "pinholes");
  expect(kPinholes + R"(, "cases": [{"objects": 8, "exposure_seconds": 1}])", "most_answer");
  expect(kPinholes + R"(, "most_answer": 9, "cases": [{"objects": 8, "exposure_seconds": 1}])", "colours");
  expect(kPinholes + R"(, "cases": [{"objects": 4, "exposure_seconds": 0}])", "exposure_seconds");
  expect(kPinholes + R"(, "least_answer": 7)" + cases, "most_answer");
  expect(kPinholes + R"(, "places": [{"row": 0, "column": 0}])" + cases, "1 places");
  expect(kPinholes + R"(, "places": [{"row": 0, "column": 0}, {"row": 0, "column": 0}])" + cases, "second time");
  expect(kPinholes + R"(, "comprehensive": {"start_row": 0, "start_column": 0})" + cases, "heading");
  expect(R"("pinholes": {"rows": 1, "columns": 1, "views": []})" + cases, "1 to 1 views");
  expect(R"("pinholes": {"rows": 1, "columns": 1,
         "views": [{"row": 0, "column": 0, "heading": "east", "south": -0.48}]})" +
             cases,
         "into a wall");
}

/// Of the viewpoints of a condition, metres.
std::set<double> heightsOf(const TaskBlock& of, TrialView view) {
  std::set<double> heights;
  for (const TrialLayout::View& each : of.start(test::planOf("count", 0, view), kScreen)->layout().views) {
    if (const auto* graph = std::get_if<GraphCamera>(&each.camera)) {
      for (const GraphCamera::Frustum& frustum : graph->frusta()) {
        heights.insert(std::round(100 * frustum.viewpoint.y) / 100);
      }
    } else {
      heights.insert(std::round(100 * static_cast<double>(std::get<PinholeCamera>(each.camera).eye().y)) / 100);
    }
  }
  return heights;
}

TEST(CountTask, conditionsShowTheVariantThatTheyAskFor) {
  TaskSetting setting = test::studySetting();
  const double walls = static_cast<double>(setting.mazes.at("small").wallHeight);
  const std::string json = R"({"maze": "small", )" + kPinholes + R"(, "comprehensive": {"eye_height": 4},
      "variants": {"low": {"comprehensive": {"eye_height": 3}},
                   "top": {"pinholes": {"rows": 1, "columns": 1, "views": [{"row": 2, "column": 2, "heading": "north",
                           "height_meters": 20, "pitch_degrees": -89}]}}},
      "cases": [{"objects": 4, "exposure_seconds": 1}]})";
  const auto heights = [&](const std::string& pinholes, const std::string& graph) {
    setting.conditions.views = {pinholeView(pinholes), graphView(graph)};
    const auto of = test::readBlock("count", json, setting);
    return std::pair(heightsOf(*of, TrialView::kReference), heightsOf(*of, TrialView::kOther));
  };
  using Heights = std::pair<std::set<double>, std::set<double>>;
  const auto rounded = [](double meters) { return std::round(100 * meters) / 100; };
  EXPECT_EQ(heights("", ""), (Heights{{1.6}, {rounded(4 * walls)}}));
  EXPECT_EQ(heights("top", "low"), (Heights{{20}, {rounded(3 * walls)}}));
  EXPECT_EQ(heights("low", "top"),
            (Heights{{1.6}, {rounded(4 * walls)}}));  // what a variant does not say is the block's
}

TEST(CountTask, pinholesLookWhereTheirFileSays) {
  const auto of = test::readBlock("count", R"({"maze": "small", "cases": [{"objects": 4, "exposure_seconds": 1}],
      "pinholes": {"rows": 2, "columns": 2, "views": [
        {"row": 2, "column": 0, "heading": "east", "fov_horizontal_degrees": 90},
        {"row": 0, "column": 0, "heading": 135, "height_meters": 5, "pitch_degrees": -45},
        {"row": 0, "column": 5, "heading": "south", "east": 0.1, "south": -0.2}]}})");
  const auto run = of->start(test::planOf("count", 0, TrialView::kReference), kScreen);
  const TrialLayout layout = run->layout();
  ASSERT_EQ(layout.views.size(), 3u);
  const auto camera = [&](size_t i) { return std::get<PinholeCamera>(layout.views[i].camera); };
  EXPECT_EQ(camera(0).eye(), glm::vec3(1.5f, 1.6f, 7.5f));
  EXPECT_NEAR(glm::distance(camera(0).forward(), glm::vec3(1, 0, 0)), 0, 1e-6);
  EXPECT_NEAR(static_cast<double>(camera(0).focalPixels()), camera(0).width() / 2.0, 1e-2);  // 90 degrees
  EXPECT_NEAR(glm::distance(camera(1).forward(), glm::vec3(0.5f, -std::sqrt(0.5f), 0.5f)), 0, 1e-6);
  EXPECT_NEAR(glm::distance(camera(2).eye(), glm::vec3(16.8f, 1.6f, 0.9f)), 0, 1e-5);
  for (size_t i = 0; i < 3; ++i) {
    for (size_t k = 0; k < i; ++k) {
      const PixelRect& a = layout.views[i].place;
      const PixelRect& b = layout.views[k].place;
      EXPECT_TRUE(a.right() <= b.left || b.right() <= a.left || a.bottom() <= b.top || b.bottom() <= a.top);
    }
  }
}

}  // namespace
}  // namespace ocelli
