#include "study/task/hidden_cells.h"

#include <gtest/gtest.h>

#include "study/task/task_layout.h"
#include "study/task/trial_image.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

SightSetting settingOf(const Maze& maze) {
  const glm::vec3 start = maze.centerOf({2, 0});
  const WalkerPose pose{static_cast<double>(start.x), static_cast<double>(start.z), 1.5707963267948966};  // to the east
  return {EyeCamera(maze, {}, {}), pose, Landmark{}};
}

/// Of the object alone, in all views.
size_t pixelsOf(const Maze& maze, const SightSetting& setting, const MazeCell& cell) {
  Maze with = maze;
  with.landmarks = {setting.object};
  with.landmarks.front().cell = cell;
  const StudyScene scene(with);
  TrialLayout layout;
  layout.scene = &scene;
  size_t pixels = 0;
  for (const TrialView view : kViews) {
    layout.views = setting.camera.views(setting.start, view, stageOf({1024, 640, 60}));
    const Image<uint32_t> seen = objectsIn(layout, layout.views.front());
    pixels += static_cast<size_t>(std::count(seen.begin(), seen.end(), 1u));
  }
  return pixels;
}

TEST(HiddenCells, AreThoseWhereNoViewShowsAPixelOfTheObjectAlone) {
  const Maze maze = test::studyMaze();
  const SightSetting setting = settingOf(maze);
  const std::vector<MazeCell> hidden = hiddenCells(maze, setting);
  size_t shown = 0;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      const bool isHidden = std::find(hidden.begin(), hidden.end(), cell) != hidden.end();
      if (cell == MazeCell{2, 0}) {
        EXPECT_FALSE(isHidden) << "one stands there";
        continue;
      }
      shown += isHidden ? 0 : 1;
      EXPECT_EQ(isHidden, pixelsOf(maze, setting, cell) == 0) << nameOf(cell);
    }
  }
  EXPECT_GT(shown, 2u);
  EXPECT_GT(hidden.size(), 2u);
}

TEST(HiddenCells, ComeByTheWayThatOneWalksToThem) {
  const Maze maze = test::studyMaze();
  const std::vector<MazeCell> hidden = hiddenCells(maze, settingOf(maze));
  for (size_t i = 1; i < hidden.size(); ++i) {
    EXPECT_LE(*maze.shortestSteps({2, 0}, hidden[i - 1]), *maze.shortestSteps({2, 0}, hidden[i]));
  }
}

TEST(HiddenCells, BandsHoldEachCellOnceAndDifferByOneAtMost) {
  std::vector<MazeCell> cells;
  for (int i = 0; i < 11; ++i) {
    cells.push_back({i, 0});
  }
  std::vector<MazeCell> all;
  for (int band = 0; band < 4; ++band) {
    const std::vector<MazeCell> of = cellsOfBand(cells, band, 4);
    EXPECT_TRUE(of.size() == 2 || of.size() == 3);
    all.insert(all.end(), of.begin(), of.end());
  }
  EXPECT_EQ(all, cells);
}

}  // namespace
}  // namespace ocelli
