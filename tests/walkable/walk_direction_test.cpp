#include "oc_core/walkable/walk_direction.h"

#include <gtest/gtest.h>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

Mesh mazeMesh() {
  return loadScene("builtin:maze,rows=3,columns=3,landmarks=0", {.fit = false, .shading = Shading::kNone});
}

TEST(WalkDirection, WallsAlongTheAxesAreNotTurned) {
  EXPECT_EQ(wallDirection(mazeMesh()), 0);
}

TEST(WalkDirection, IsTheAngleByWhichASceneWasTurned) {
  for (const double degrees : {1.0, 27.0, 45.0, 63.5, 89.0}) {
    const Mesh turned = turnedAboutVertical(mazeMesh(), radiansFromDegrees(degrees));
    // Coordinates of ten metres are floats, of a micrometre: walls of a metre are out by less than a second of arc.
    EXPECT_NEAR(degreesFromRadians(wallDirection(turned)), degrees, 1e-3) << degrees;
  }
}

TEST(WalkDirection, RightAnglesAreOneDirection) {
  const Mesh turned = turnedAboutVertical(mazeMesh(), radiansFromDegrees(90 + 27));
  EXPECT_NEAR(degreesFromRadians(wallDirection(turned)), 27, 1e-3);
}

TEST(WalkDirection, TurningGoesFromXTowardsMinusZ) {
  Mesh mesh;
  mesh.positions = {{1, 2, 0}};
  const glm::vec3 turned = turnedAboutVertical(mesh, kPi / 2).positions[0];
  EXPECT_NEAR(turned.x, 0, 1e-6);
  EXPECT_EQ(turned.y, 2);
  EXPECT_NEAR(turned.z, -1, 1e-6);
}

TEST(WalkDirection, FloorsAloneHaveNone) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 2}, {2, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(wallDirection(mesh), 0);
}

}  // namespace
}  // namespace ocelli
