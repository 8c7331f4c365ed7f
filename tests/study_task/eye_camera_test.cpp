#include "study/task/eye_camera.h"

#include <gtest/gtest.h>

#include "oc_core/base/conventions.h"
#include "tests/study_task/maze_walks.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

TEST(EyeCamera, looksWhereOneLooks) {
  const Maze maze = test::studyMaze();
  const EyeCamera camera(maze, {}, {});
  const PinholeCamera pinhole = camera.pinhole({4.5, 7.5, kPi / 2}, {800, 400});
  EXPECT_EQ(pinhole.eye(), glm::vec3(4.5f, 1.6f, 7.5f));
  // 70 degrees from side to side: what lies 35 degrees aside is at the border.
  const auto ahead = pinhole.project({9.5f, 1.6f, 7.5f});
  const auto aside = pinhole.project({9.5f, 1.6f, 7.5f + 5 * std::tan(35 * 3.14159265f / 180)});
  ASSERT_TRUE(ahead && aside);
  EXPECT_NEAR(ahead->u, 400, 1e-2);
  EXPECT_NEAR(ahead->v, 200, 1e-2);
  EXPECT_NEAR(aside->u, 800, 1e-2);
}

TEST(EyeCamera, theGraphCameraBendsIntoSideWays) {
  const Maze maze = test::studyMaze();
  const EyeCamera camera(maze, {}, {});
  const WalkerPose pose{2.5, 7.5, kPi / 2};
  const auto graph = camera.portalCamera(pose, {640, 400});
  ASSERT_TRUE(graph.has_value());
  EXPECT_GT(graph->frusta().size(), 2u);
  const PixelRect place{10, 20, 640, 400};
  const auto pinholes = camera.views(pose, TrialView::kReference, place);
  ASSERT_EQ(pinholes.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<PinholeCamera>(pinholes.front().camera));
  EXPECT_EQ(pinholes.front().place, place);
  const auto graphs = camera.views(pose, TrialView::kOther, place);
  ASSERT_EQ(graphs.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<GraphCamera>(graphs.front().camera));
  EXPECT_EQ(graphs.front().place, place);
}

// Trials that are stored replay with the cameras that their subjects saw: these are the numbers of the first version,
// whatever the usual curve of portals is.
TEST(EyeCamera, keepsThePortalsOfTheFirstVersion) {
  const PortalOptions portals = EyeCameraOptions().portals;
  EXPECT_EQ(portals.straightWithin, 0.1);
  EXPECT_EQ(portals.bentBeyond, 3);
  EXPECT_EQ(portals.farthest, 12);
  EXPECT_EQ(portals.straightDegrees, 5);
  EXPECT_EQ(portals.bentDegrees, 65);
  EXPECT_EQ(portals.edgeDegrees, 87);
  EXPECT_EQ(portals.edgeFadeDegrees, 4);
  EXPECT_EQ(portals.handOver, 0.5);
}

TEST(EyeCamera, takesWhateverPoseOneCanHave) {
  EXPECT_EQ(test::refusedPoses(30, 60), 0);
}

TEST(EyeCamera, portalsOfOnePlaceAreRefused) {
  const std::string error = test::readError("find", R"({"maze": "small", "cases": [{"row": 0, "column": 0}],
      "portals": {"portals": [{"center": [1, 1, 1], "normal": [0, 0, 1], "width": 1, "height": 1}]}})");
  EXPECT_NE(error.find("openings of the maze"), std::string::npos) << error;
}

}  // namespace
}  // namespace ocelli
