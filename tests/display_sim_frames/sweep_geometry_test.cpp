#include "display_sim/frames/sweep_geometry.h"

#include <gtest/gtest.h>

#include "oc_core/base/conventions.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

// Rounding of a few operations on numbers of at most 1.
constexpr double kRounding = 1e-15;

TEST(SweepGeometry, followsTheConvention) {
  const SweepGeometry sweep(loadProfile("perspecta"));
  for (const int slice : {0, 1, 50, 197}) {
    const double t = slice * kPi / 198;
    for (const int column : {0, 383, 384, 767}) {
      const double r = (column + 0.5 - 384) / 384;
      const glm::dvec3 p = sweep.voxelCenter(slice, column, 7);
      EXPECT_NEAR(p.x, r * std::cos(t), kRounding);
      EXPECT_NEAR(p.y, 1 - 7.5 / 384, kRounding);
      EXPECT_NEAR(p.z, r * std::sin(t), kRounding);
    }
  }
}

TEST(SweepGeometry, aQuarterTurnIsExact) {
  const SweepGeometry sweep(loadProfile("perspecta"));
  EXPECT_EQ(sweep.sectorDirection(99), glm::dvec2(0, 1));
  EXPECT_EQ(sweep.sectorDirection(198), glm::dvec2(-1, 0));
}

TEST(SweepGeometry, theSecondHalfTurnMirrorsTheFirst) {
  const SweepGeometry sweep(test::smallProfile(7, 10, 6));
  for (int slice = 0; slice < 7; ++slice) {
    for (int column = 0; column < 10; ++column) {
      const glm::dvec3 difference = sweep.voxelCenter(slice, column, 2) - sweep.voxelCenter(slice + 7, 9 - column, 2);
      EXPECT_NEAR(difference.x, 0, kRounding);
      EXPECT_NEAR(difference.z, 0, kRounding);
    }
  }
}

TEST(SweepGeometry, rowsAndHeightsInvert) {
  const SweepGeometry sweep(loadProfile("vortex"));
  EXPECT_DOUBLE_EQ(sweep.rowHeight(), sweep.columnWidth());
  for (int row = 0; row < 64; ++row) {
    EXPECT_NEAR(sweep.rowOfY(sweep.rowCenterY(row)), row + 0.5, 1e-13);
  }
  EXPECT_EQ(sweep.rowOfY(0.5), 0);
  EXPECT_EQ(sweep.rowOfY(-0.5), 64);
}

}  // namespace
}  // namespace ocelli
