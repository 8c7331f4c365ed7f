#include "study/agent/visibility_sensor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/conventions.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

using testing::Each;
using testing::Field;
using testing::IsEmpty;
using testing::SizeIs;

/// The maze of the tests with an object in each of these cells.
StudyScene sceneWith(const std::vector<MazeCell>& cells) {
  Maze maze = test::studyMaze();
  for (size_t i = 0; i < cells.size(); ++i) {
    maze.landmarks.push_back({cells[i], LandmarkShape::kSphere, static_cast<LandmarkColor>(i)});
  }
  return StudyScene(maze);
}

/// A pinhole in the middle of a cell.
PinholeCamera cameraIn(const Maze& maze, const MazeCell& cell, Direction heading, int width, int height) {
  View view;
  view.eye = maze.centerOf(cell) + glm::vec3(0, 1.6f, 0);
  view.target = view.eye + vectorOf(heading);
  view.fovVerticalDegrees = 45;
  view.zNear = 0.05f;
  view.zFar = 200;
  return {view, width, height};
}

TrialLayout imageOf(const StudyScene& scene, const StudyCamera& camera, double left = 0, double top = 0) {
  TrialLayout layout;
  layout.scene = &scene;
  const auto* pinhole = std::get_if<PinholeCamera>(&camera);
  const int width = pinhole ? pinhole->width() : std::get<GraphCamera>(camera).width();
  const int height = pinhole ? pinhole->height() : std::get<GraphCamera>(camera).height();
  layout.views.emplace_back(PixelRect{left, top, static_cast<double>(width), static_cast<double>(height)}, camera);
  return layout;
}

constexpr TrialScreen kScreen{320, 200, 60};

TEST(VisibilitySensor, seesAnObjectAheadWithThePixelsOfItsImage) {
  // Down the corridor of row 2, from its west end: two cells ahead.
  const StudyScene scene = sceneWith({{2, 2}});
  const PinholeCamera camera = cameraIn(scene.maze(), {2, 0}, Direction::kEast, 320, 200);
  const TrialLayout layout = imageOf(scene, camera);
  const Percept percept = VisibilitySensor(kScreen).look(layout, false);
  ASSERT_THAT(percept.objects, SizeIs(1));
  const Sighting& seen = percept.objects[0];
  EXPECT_EQ(seen.shape, LandmarkShape::kSphere);
  EXPECT_EQ(seen.color, LandmarkColor::kOrange);

  size_t pixels = 0;
  const Image<uint32_t> identities =
      identityImage(rasterizeStudy(camera, scene.bare().mesh()), scene.bare().objectOfTriangle());
  for (const uint32_t identity : identities) {
    pixels += identity == 1 ? 1 : 0;
  }
  EXPECT_GT(pixels, 20u);
  EXPECT_EQ(seen.pixels, pixels);
  // Where its middle is projected, as far as what shows of a sphere from above has its middle elsewhere: its radius.
  const auto middle = camera.project(scene.boxOf(0).center());
  ASSERT_TRUE(middle.has_value());
  const double radius = static_cast<double>(camera.focalPixels() * scene.boxOf(0).size().x / 2 / middle->t);
  EXPECT_NEAR(seen.centroid.x, static_cast<double>(middle->u), radius / 4);
  EXPECT_NEAR(seen.centroid.y, static_cast<double>(middle->v), radius / 4);
  const glm::vec3 place = scene.boxOf(0).center();
  EXPECT_NEAR(seen.place.x, static_cast<double>(place.x), static_cast<double>(scene.boxOf(0).size().x) / 2);
  EXPECT_NEAR(seen.place.y, static_cast<double>(place.z), static_cast<double>(scene.boxOf(0).size().z) / 2);
}

TEST(VisibilitySensor, seesTheSameInTheBareSceneAsInTheOneThatIsShown) {
  const StudyScene scene = sceneWith({{2, 2}, {0, 4}});
  EXPECT_LT(scene.bare().mesh().triangles.size(), scene.mesh().triangles.size() / 4);
  for (const Direction heading : kDirections) {
    const PinholeCamera camera = cameraIn(scene.maze(), {2, 0}, heading, 320, 200);
    const Image<uint32_t> bare =
        identityImage(rasterizeStudy(camera, scene.bare().mesh()), scene.bare().objectOfTriangle());
    const Image<uint32_t> shown = identityImage(rasterizeStudy(camera, scene.mesh()), scene.objectOfTriangle());
    size_t different = 0;
    for (size_t i = 0; i < bare.size(); ++i) {
      different += bare[i] != shown[i] ? 1 : 0;
    }
    // Edges are rounded to 1/256 of a pixel from other corners: of 64000 pixels hardly one changes sides.
    EXPECT_LE(different, 8u);
  }
}

TEST(VisibilitySensor, seesNothingBehindAWallAndNothingBehindItsBack) {
  // Row 0 is one corridor; a wall stands between it and cell (1, 1), and (2, 2) is behind another.
  const StudyScene scene = sceneWith({{1, 1}, {2, 2}, {0, 0}});
  const PinholeCamera camera = cameraIn(scene.maze(), {0, 1}, Direction::kEast, 320, 200);
  const Percept percept = VisibilitySensor(kScreen).look(imageOf(scene, camera), true);
  EXPECT_THAT(percept.objects, IsEmpty());
  EXPECT_THAT(percept.floor, Each(Field(&FloorPatch::cell, Field(&MazeCell::column, testing::Ge(0)))));
  for (const FloorPatch& patch : percept.floor) {
    EXPECT_NE(patch.cell, (MazeCell{1, 1})) << "behind a wall";
    EXPECT_NE(patch.cell, (MazeCell{0, 0})) << "behind the back";
  }
}

TEST(VisibilitySensor, tellsAtWhatScaleAndTurnedWhichWayThePictureIs) {
  const StudyScene scene = sceneWith({{2, 2}});
  const Box& box = scene.boxOf(0);
  for (const glm::vec3 up : {glm::vec3(0, 0, -1), glm::vec3(1, 0, 0)}) {
    // From straight above; what is at the top of the picture is in the north, or in the east.
    View view;
    view.target = glm::vec3(box.center().x, 0, box.center().z);
    view.eye = view.target + glm::vec3(0, 20, 0);
    view.up = up;
    view.fovVerticalDegrees = 30;
    view.zNear = 0.1f;
    view.zFar = 100;
    const PinholeCamera camera(view, 320, 200);
    const Percept percept = VisibilitySensor(kScreen).look(imageOf(scene, camera), false);
    ASSERT_THAT(percept.objects, SizeIs(1));
    ASSERT_TRUE(percept.objects[0].perspective.has_value());
    const PicturePerspective& seen = *percept.objects[0].perspective;
    // Walls and the object are nearer than the floor, by up to 2.4 m of 20.
    const double least = static_cast<double>(camera.focalPixels()) / 20;
    EXPECT_GT(seen.pixelsPerMeter(), least);
    EXPECT_LT(seen.pixelsPerMeter(), least * 20 / (20 - 2.4));
    // East at the top: the picture of the maze is turned to the left.
    EXPECT_NEAR(seen.turnRadians(), up.x > 0 ? -kPi / 2 : 0, 0.05);
  }
}

TEST(VisibilitySensor, placesThingsOnTheScreenWhereTheirViewIs) {
  const StudyScene scene = sceneWith({{2, 2}});
  const PinholeCamera camera = cameraIn(scene.maze(), {2, 0}, Direction::kEast, 160, 100);
  const Percept here = VisibilitySensor(kScreen).look(imageOf(scene, camera), true);
  const Percept there = VisibilitySensor(kScreen).look(imageOf(scene, camera, 150, 90), true);
  ASSERT_EQ(here.objects.size(), there.objects.size());
  EXPECT_EQ(there.objects[0].centroid, here.objects[0].centroid + glm::dvec2(150, 90));
  EXPECT_EQ(there.objects[0].aim, here.objects[0].aim + glm::dvec2(150, 90));
  ASSERT_EQ(here.floor.size(), there.floor.size());
  EXPECT_NEAR(there.floor[0].centroid.x, here.floor[0].centroid.x + 150, 1e-9);
}

TEST(VisibilitySensor, knowsWaysThatAreOpenAndNoOthers) {
  const StudyScene scene = sceneWith({});
  for (const Direction heading : kDirections) {
    for (const MazeCell cell : {MazeCell{0, 0}, MazeCell{2, 2}, MazeCell{2, 5}, MazeCell{4, 3}}) {
      const PinholeCamera camera = cameraIn(scene.maze(), cell, heading, 320, 200);
      const Percept percept = VisibilitySensor(kScreen).look(imageOf(scene, camera), true);
      for (const FloorPatch& patch : percept.floor) {
        if (patch.way) {
          EXPECT_TRUE(scene.maze().isOpen(patch.cell, *patch.way)) << nameOf(patch.cell) << nameOf(*patch.way);
        }
      }
      ASSERT_TRUE(percept.standing.has_value());
      const glm::vec3 middle = scene.maze().centerOf(cell);
      EXPECT_EQ(percept.standing->x, static_cast<double>(middle.x));
      EXPECT_NEAR(std::remainder(percept.standing->headingRadians - static_cast<double>(heading) * kPi / 2, 2 * kPi), 0,
                  1e-6);
    }
  }
}

TEST(VisibilitySensor, seesAroundCornersWhatBentRaysShow) {
  // A find trial from the entrance: the portal-based camera shows side corridors, the pinhole does not.
  const auto block = test::readBlock("find", R"({"maze": "small", "cases": [{"row": 2, "column": 4}]})");
  const auto percept = [&](TrialView view) {
    return VisibilitySensor(kScreen).look(block->start(test::planOf("find", 0, view), kScreen)->layout(), true);
  };
  size_t bent = 0;
  for (const FloorPatch& patch : percept(TrialView::kOther).floor) {
    bent += patch.straight ? 0 : 1;
  }
  EXPECT_GT(bent, 0u);
  EXPECT_THAT(percept(TrialView::kReference).floor, Each(Field(&FloorPatch::straight, true)));
  EXPECT_GT(percept(TrialView::kOther).floor.size(), percept(TrialView::kReference).floor.size());
}

TEST(VisibilitySensor, joinsWhatAPostCutsInTwoAndKeepsThingsApart) {
  // Two objects far apart in one corridor; the nearer one hides part of nothing.
  const StudyScene scene = sceneWith({{2, 2}, {2, 4}});
  const PinholeCamera camera = cameraIn(scene.maze(), {2, 0}, Direction::kEast, 320, 200);
  const Percept percept = VisibilitySensor(kScreen).look(imageOf(scene, camera), false);
  size_t orange = 0;
  for (const Sighting& seen : percept.objects) {
    orange += seen.color == LandmarkColor::kOrange ? 1 : 0;
  }
  EXPECT_EQ(orange, 1u);
}

TEST(VisibilitySensor, getsNothingOfABlackScreen) {
  const auto block = test::readBlock("find", R"({"maze": "small", "cases": [{"row": 3, "column": 3}]})");
  const auto black = [](const StudyCamera& camera, const Mesh&) {
    return std::visit([](const auto& each) { return FragmentImage(each.width(), each.height()); }, camera);
  };
  const auto run = block->start(test::planOf("find", 0, TrialView::kReference), kScreen);
  const Percept percept = VisibilitySensor(kScreen, black).look(run->layout(), true);
  EXPECT_THAT(percept.objects, IsEmpty());
  EXPECT_THAT(percept.floor, IsEmpty());
  EXPECT_THAT(percept.surfaces, IsEmpty());
  EXPECT_THAT(VisibilitySensor(kScreen).look(run->layout(), true).objects, SizeIs(1));
}

}  // namespace
}  // namespace ocelli
