#include "display_sim/volume_slicing/cell_share.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

/// Of many points spread evenly over the block.
double countedShare(double distance, const glm::dvec3& reaches) {
  constexpr int kPoints = 60;
  const auto at = [](int i) { return 2 * (i + 0.5) / kPoints - 1; };
  int inside = 0;
  for (int i = 0; i < kPoints; ++i) {
    for (int j = 0; j < kPoints; ++j) {
      for (int k = 0; k < kPoints; ++k) {
        inside += distance + at(i) * reaches.x + at(j) * reaches.y + at(k) * reaches.z > 0 ? 1 : 0;
      }
    }
  }
  return static_cast<double>(inside) / (kPoints * kPoints * kPoints);
}

TEST(CellShare, IsThatOfManyPoints) {
  for (const glm::dvec3& reaches :
       {glm::dvec3(1, 1, 1), glm::dvec3(0.2, 0.5, 0.3), glm::dvec3(1, 0.05, 0.4), glm::dvec3(0.7, 0, 0.3)}) {
    for (double distance = -2; distance <= 2; distance += 0.13) {
      // A face that is parallel to the plane takes or leaves a layer of points, of 60.
      EXPECT_NEAR(shareOfBlock(distance, reaches), countedShare(distance, reaches), 1.0 / 60) << distance;
    }
  }
}

TEST(CellShare, IsExactForParallelFaces) {
  EXPECT_DOUBLE_EQ(shareOfBlock(0.25, {0, 0.5, 0}), 0.75);
  EXPECT_DOUBLE_EQ(shareOfBlock(-0.5, {0, 0.5, 0}), 0);
  EXPECT_DOUBLE_EQ(shareOfBlock(7, {0, 0.5, 0}), 1);
  // A block without a thickness across the plane lies on one side of it.
  EXPECT_EQ(shareOfBlock(1e-9, {0, 0, 0}), 1);
  EXPECT_EQ(shareOfBlock(-1e-9, {0, 0, 0}), 0);
}

// Where short edges begin to count nothing jumps, and no digits are lost.
TEST(CellShare, IsSteadyAsEdgesShrink) {
  for (const double distance : {-0.9, -0.2, 0.1, 0.6}) {
    double last = shareOfBlock(distance, {1, 0.5, 0});
    for (double shortest = 1e-6; shortest < 1e-2; shortest *= 1.5) {
      const double share = shareOfBlock(distance, {1, 0.5, shortest});
      // An edge of 0.01 changes the share by 0.01^2 at the most.
      EXPECT_NEAR(share, last, 1e-4);
      last = share;
    }
  }
}

}  // namespace
}  // namespace ocelli
