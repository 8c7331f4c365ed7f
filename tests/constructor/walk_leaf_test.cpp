#include "oc_core/constructor/walk_leaf.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

constexpr double kRounding = 1e-5;  // views are of floats

/// 4 m wide; the door leads into it in the direction of z.
WalkRegion roomBeyondADoor(double depth) {
  WalkRegion region;
  region.border = planHull({{0, 0}, {4, 0}, {4, depth}, {0, depth}});
  region.height = 2.7;
  region.size = 2.7;
  return region;
}

/// Of someone 3 m before the door.
GraphCamera walkerBeforeADoor() {
  View view;
  view.eye = {2, 1, -3};
  view.target = {2, 1, 0};
  return GraphCamera(PinholeCamera(view, 300, 200));
}

WalkMouth doorOf(double top) {
  return {{2.5, 0}, {1.5, 0}, 0, top};
}

PieceRays raysThrough(double top) {
  return {GraphCamera::kRoot, doorOf(top), 0};
}

TEST(WalkLeaf, raysThroughADoorPartBeyondMostOfItsLeaf) {
  const WalkMouth beyond = beyondLeaf(walkerBeforeADoor(), roomBeyondADoor(4), raysThrough(2), doorOf(2));
  // 0.7 m behind the door, where rays from 3 m before it have spread by 3.7 / 3.
  EXPECT_NEAR(beyond.left.x, 2 + 0.5 * 3.7 / 3, kRounding);
  EXPECT_NEAR(beyond.left.y, 0.7, kRounding);
  EXPECT_NEAR(beyond.right.x, 2 - 0.5 * 3.7 / 3, kRounding);
  EXPECT_NEAR(beyond.right.y, 0.7, kRounding);
  EXPECT_EQ(beyond.floor, 0);
  EXPECT_EQ(beyond.top, 2);  // rays that have risen above the door see the wall
}

TEST(WalkLeaf, raysThroughADoorPartWithinTheRoom) {
  EXPECT_NEAR(beyondLeaf(walkerBeforeADoor(), roomBeyondADoor(1), raysThrough(2), doorOf(2)).middle().y, 0.4,
              kRounding);
}

TEST(WalkLeaf, raysThroughWhatHasNoLintelPartAtOnce) {
  const WalkMouth arch = beyondLeaf(walkerBeforeADoor(), roomBeyondADoor(4), raysThrough(2.7), doorOf(2.7));
  EXPECT_EQ(arch.left, glm::dvec2(2.5, 0));
  EXPECT_EQ(arch.right, glm::dvec2(1.5, 0));
  EXPECT_EQ(arch.top, 2.7);
  // Nor where they see the lower part of it alone.
  EXPECT_EQ(beyondLeaf(walkerBeforeADoor(), roomBeyondADoor(4), raysThrough(1.5), doorOf(2.7)).left, arch.left);
}

}  // namespace
}  // namespace ocelli
