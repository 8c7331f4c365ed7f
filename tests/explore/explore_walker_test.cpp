#include "oc_core/explore/explore_walker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/explore/explore_scenes.h"

namespace ocelli {
namespace {

WalkInput forwards(double share = 1) {
  WalkInput input;
  input.forward = share;
  return input;
}

void walk(ExploreWalker& walker, const WalkInput& input, double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / test::kExploreFrame)); ++i) {
    walker.step(input, test::kExploreFrame);
  }
}

TEST(ExploreWalker, headingsAndDirectionsAgree) {
  for (const double heading : {-170.0, -90.0, 0.0, 33.0, 90.0, 179.0}) {
    const glm::dvec3 direction = headingOf({{}, heading, 0});
    EXPECT_NEAR(headingDegreesOf(direction), heading, 1e-9);
  }
  EXPECT_NEAR(lookOf({{}, 90, 30}).x, std::cos(30 * 3.14159265358979 / 180), 1e-9);
  EXPECT_NEAR(lookOf({{}, 90, 30}).y, 0.5, 1e-9);
  EXPECT_EQ(headingDegreesOf({0, 1, 0}, 12), 12);
}

TEST(ExploreWalker, turnsTheShorterWayBetweenViews) {
  EXPECT_NEAR(between({{}, 170, 0}, {{}, -170, 0}, 0.5).headingDegrees, 180, 1e-9);
  EXPECT_NEAR(between({{}, 10, 0}, {{}, -10, 20}, 0.5).pitchDegrees, 10, 1e-9);
}

TEST(ExploreWalker, goesAtItsSpeed) {
  const ExploreScene scene(test::hall());
  ExploreWalker walker(scene, {});
  walker.jump({{0, 1.6, 0}, 0, 0});
  walk(walker, forwards(), 2);
  EXPECT_NEAR(walker.view().eye.z, -2 * walker.options().speed, 1e-6);
  EXPECT_NEAR(walker.view().eye.x, 0, 1e-9);
  EXPECT_NEAR(walker.view().eye.y, 1.6, 1e-5) << "the eye is at its height over the floor";
  EXPECT_TRUE(walker.overFloor());
  EXPECT_FALSE(walker.atWall());
}

TEST(ExploreWalker, stopsAtItsRadiusFromAWall) {
  const ExploreScene scene(test::hall());
  ExploreWalker walker(scene, {});
  walker.jump({{0, 1.6, 0}, 0, 0});
  walk(walker, forwards(), 20);
  EXPECT_NEAR(walker.view().eye.z, -10 + walker.options().radius, 1e-4);
  EXPECT_TRUE(walker.atWall());
}

TEST(ExploreWalker, slidesAlongAWallAndStopsInACorner) {
  const ExploreScene scene(test::hall());
  ExploreWalker walker(scene, {});
  walker.jump({{0, 1.6, 0}, 45, 0});
  walk(walker, forwards(), 30);
  const double border = 10 - walker.options().radius;
  EXPECT_NEAR(walker.view().eye.x, border, 1e-3);
  EXPECT_NEAR(walker.view().eye.z, -border, 1e-3);
}

// From wherever one goes to wherever: never into a wall, and never through it.
TEST(ExploreWalker, neverComesThroughAWall) {
  const ExploreScene scene(test::twoRooms());
  ExploreWalker walker(scene, {});
  for (int i = 0; i < 24; ++i) {
    walker.jump({{2, 1.6, 0}, i * 15.0, 0});
    WalkInput input = forwards();
    input.right = i % 3 - 1;
    input.fast = i % 2 == 0;
    walk(walker, input, 12);
    const glm::dvec3 eye = walker.view().eye;
    EXPECT_LT(std::abs(eye.x), 10);
    EXPECT_LT(std::abs(eye.z), 10);
    EXPECT_TRUE(eye.z > -2.9 || std::abs(eye.z + 3) > 0.3) << "heading " << i * 15;
  }
}

TEST(ExploreWalker, goesThroughADoor) {
  const ExploreScene scene(test::twoRooms());
  ExploreWalker walker(scene, {});
  walker.jump({{0.1, 1.6, 0}, 0, 0});
  walk(walker, forwards(), 4);
  EXPECT_LT(walker.view().eye.z, -5);
}

TEST(ExploreWalker, climbsStepsAndNotBoxes) {
  GuidedScene made = test::hall();
  test::addBox(made, {{-2, 0, -6}, {2, 0.3f, -2}}, 0, glm::vec3(0.5f));
  test::addBox(made, {{-2, 0, -9}, {2, 0.6f, -4}}, 0, glm::vec3(0.5f));
  test::addBox(made, {{-2, 0, -9.9f}, {2, 1.8f, -7}}, 0, glm::vec3(0.5f));
  const ExploreScene scene(std::move(made));
  ExploreWalker walker(scene, {});
  walker.jump({{0, 1.6, 0}, 0, 0});
  walk(walker, forwards(), 10);
  EXPECT_NEAR(walker.view().eye.y, 0.6 + 1.6, 1e-3) << "two steps up";
  EXPECT_NEAR(walker.view().eye.z, -7 + walker.options().radius, 1e-3) << "a box of 1.2 m more is a wall";
}

TEST(ExploreWalker, staysOnARoof) {
  GuidedScene made = test::hall();
  test::addBox(made, {{-2, 0, -6}, {2, 5, -2}}, 0, glm::vec3(0.5f));
  const ExploreScene scene(std::move(made));
  ExploreWalker walker(scene, {});
  walker.jump({{0, 6.6, -4}, 0, 0});
  ASSERT_NEAR(walker.view().eye.y, 6.6, 1e-4);
  walk(walker, forwards(), 10);
  EXPECT_GE(walker.view().eye.z, -6);
  EXPECT_NEAR(walker.view().eye.y, 6.6, 1e-4);
}

TEST(ExploreWalker, floatsWhereThereIsNoFloor) {
  GuidedScene made;
  test::addBox(made, {{-3, -3, -3}, {3, 3, 3}}, 1, glm::vec3(0.5f));
  const ExploreScene scene(std::move(made));
  ExploreWalker walker(scene, {});
  walker.jump({{0, 1, 9}, 0, 0});
  EXPECT_FALSE(walker.overFloor());
  WalkInput up;
  up.up = 1;
  walk(walker, up, 1);
  EXPECT_NEAR(walker.view().eye.y, 1 + walker.options().speed, 1e-6);
}

TEST(ExploreWalker, fliesThroughWalls) {
  const ExploreScene scene(test::hall());
  ExploreWalker walker(scene, {});
  walker.options().fly = true;
  walker.jump({{0, 1.6, 0}, 0, 0});
  walk(walker, forwards(), 10);
  EXPECT_LT(walker.view().eye.z, -12);
}

TEST(ExploreWalker, looksNoHigherThanItCan) {
  const ExploreScene scene(test::hall());
  ExploreWalker walker(scene, {});
  WalkInput up;
  up.pointerDegrees = {10, 500};
  walker.step(up, test::kExploreFrame);
  EXPECT_EQ(walker.view().pitchDegrees, walker.options().maxPitch);
}

TEST(ExploreWalker, isAsWideAsAsked) {
  const ExploreScene scene(test::hall());
  for (const int height : {90, 160, 45}) {
    const PinholeCamera camera = walkerCamera({{0, 1.6, 0}, 90, 0}, scene, 70, 160, height);
    EXPECT_NEAR(80 / camera.focalPixels(), std::tan(35 * 3.14159265358979 / 180), 1e-5);
    EXPECT_NEAR(camera.forward().x, 1, 1e-6);
  }
}

TEST(OpenPlace, isOnTheFloorOfAHall) {
  const ExploreScene scene(test::hall());
  const WalkerView view = openPlace(scene, {});
  EXPECT_NEAR(view.eye.y, 1.6, 1e-4);
  EXPECT_LT(std::abs(view.eye.x), 9);
}

TEST(OpenPlace, beginsAPath) {
  const ExploreScene scene(test::hallWithPath());
  const WalkerView view = openPlace(scene, {});
  EXPECT_EQ(glm::vec3(view.eye), glm::vec3(-7, 1.6f, 8));
  EXPECT_NEAR(view.headingDegrees, 0, 1e-6);
}

TEST(OpenPlace, seesASceneWithoutAFloorFromOutside) {
  GuidedScene made;
  const glm::vec3 a(-3, -3, 0);
  made.mesh.positions = {a, {3, -3, 0}, {0, 3, 0}};
  made.mesh.colors.assign(3, glm::vec3(1));
  made.mesh.triangles = {{0, 1, 2}};
  made.objectOfTriangle = {1};
  const ExploreScene scene(std::move(made));
  const WalkerView view = openPlace(scene, {});
  const PinholeCamera camera = walkerCamera(view, scene, 70, 160, 90);
  for (const glm::vec3& corner : scene.mesh().positions) {
    const std::optional<ImagePoint> image = camera.project(corner);
    ASSERT_TRUE(image);
    EXPECT_TRUE(image->u > 0 && image->u < 160 && image->v > 0 && image->v < 90);
  }
}

}  // namespace
}  // namespace ocelli
