// Slopes, steps, and storeys over each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oc_core/walkable/walkable.h"
#include "tests/walkable/walkable_floors.h"

namespace ocelli {
namespace {

/// A wedge whose top rises from x = `from` to `to`.
void addRamp(Mesh& mesh, float from, float to, float rise) {
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  for (const float z : {0.0f, 2.0f}) {
    mesh.positions.insert(mesh.positions.end(), {{from, 0, z}, {to, 0, z}, {to, rise, z}});
  }
  mesh.triangles.insert(mesh.triangles.end(), {{first, first + 5, first + 2}, {first, first + 3, first + 5}});
}

TEST(WalkableStairs, ASlopeRises) {
  Mesh mesh;
  addRamp(mesh, 0, 10, 3);  // 17 degrees
  const WalkMap map = findWalkMap(mesh, {});
  float rise = 0;
  for (const WalkCell& cell : map.cells) {
    rise += std::abs(cell.floorRise);
    EXPECT_NEAR(cell.center.y, cell.center.x * 0.3f, 0.06f);
    EXPECT_NEAR(std::abs(cell.floorRise), 2 * cell.halfLength * 0.3f, 0.15f);
  }
  EXPECT_NEAR(rise, 3, 0.2f);
}

TEST(WalkableStairs, ASteepSlopeIsNoFloor) {
  Mesh mesh;
  addRamp(mesh, 0, 3, 3);  // 45 degrees
  EXPECT_NE(test::walkErrorOf(mesh), "");
  WalkOptions climber;
  climber.slopeDegrees = 50;
  EXPECT_EQ(test::walkErrorOf(mesh, climber), "");
}

/// A lower floor with a flight of steps along its north wall, and an upper floor beyond.
Mesh twoStoreys(float riser) {
  Mesh mesh;
  test::addFloor(mesh, {0, 0}, {12, 6});
  test::addWalls(mesh, {0, 0}, {12, 6}, 6);
  const int steps = static_cast<int>(std::lround(3 / riser));
  for (int i = 0; i < steps; ++i) {
    const float x = 2 + 0.3f * static_cast<float>(i);
    test::addBox(mesh, {x, 0, 0}, {x + 0.3f, riser * static_cast<float>(i + 1), 1.2f});
  }
  const float end = 2 + 0.3f * static_cast<float>(steps);
  test::addFloor(mesh, {end, 0}, {12, 6}, 3);        // behind the last step
  test::addFloor(mesh, {0, 2.5f}, {end, 6}, 3);      // beside the well
  test::addBox(mesh, {0, 3, 2.5f}, {end, 4, 2.6f});  // a parapet
  return mesh;
}

TEST(WalkableStairs, StoreysAreJoinedByTheirStairs) {
  const WalkMap map = findWalkMap(twoStoreys(0.1875f), {});
  const int below = test::cellAt(map, {1, 0, 4});
  const int above = test::cellAt(map, {3, 3, 4});
  ASSERT_GE(below, 0);
  ASSERT_GE(above, 0);
  EXPECT_EQ(*std::max_element(map.partOfCell.begin(), map.partOfCell.end()), 0U) << "one walks up";
  const auto flight = std::max_element(map.cells.begin(), map.cells.end(), [](const WalkCell& a, const WalkCell& b) {
    return std::abs(a.floorRise) < std::abs(b.floorRise);
  });
  EXPECT_NEAR(std::abs(flight->floorRise), 3, 0.5f);
  const auto roomOf = [&](int cell) { return map.roomOfCell[static_cast<size_t>(cell)]; };
  const int stairs = static_cast<int>(flight - map.cells.begin());
  EXPECT_NE(roomOf(stairs), roomOf(below));
  EXPECT_NE(roomOf(stairs), roomOf(above));
  EXPECT_NEAR(2 * flight->halfWidth, 1.2f, 0.25f);
  EXPECT_GT(std::abs(flight->axis.x), 0.99f);
}

TEST(WalkableStairs, StepsThatAreTooHighPartTheStoreys) {
  WalkOptions options;
  options.partShare = 0;  // else the upper floor is a roof
  const WalkMap map = findWalkMap(twoStoreys(0.5f), options);
  const int below = test::cellAt(map, {1, 0, 4});
  const int above = test::cellAt(map, {3, 3, 4});
  ASSERT_GE(below, 0);
  ASSERT_GE(above, 0);
  EXPECT_NE(map.partOfCell[below], map.partOfCell[above]);
}

TEST(WalkableStairs, KerbsAreStepped) {
  for (int shift = 0; shift < 10; ++shift) {  // of the kerb, against the grid of the height field
    Mesh mesh;
    test::addFloor(mesh, {0, 0}, {10, 10});
    // A pavement that is hollow: no floor lies in the column of its edge.
    const float edge = 5 + 0.01f * static_cast<float>(shift);
    mesh.positions.insert(
        mesh.positions.end(),
        {{0, 0.15f, edge}, {10, 0.15f, edge}, {10, 0.15f, 10}, {0, 0.15f, 10}, {0, 0, edge}, {10, 0, edge}});
    const auto first = static_cast<uint32_t>(mesh.positions.size()) - 6;
    mesh.triangles.insert(mesh.triangles.end(), {{first, first + 2, first + 1},
                                                 {first, first + 3, first + 2},
                                                 {first, first + 1, first + 5},
                                                 {first, first + 5, first + 4}});
    const WalkMap map = findWalkMap(mesh, {});
    EXPECT_EQ(map.cells.size(), 1U) << shift;
  }
}

}  // namespace
}  // namespace ocelli
