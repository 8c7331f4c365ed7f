#include "display_driver/devices/voxel_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <ostream>

namespace ocelli {
namespace {

TEST(VoxelGrid, hasTheOrderOfMultivoxDisplays) {
  const VoxelGrid grid;
  EXPECT_EQ(grid.cells(), 128u * 128 * 64);
  EXPECT_EQ(grid.index(1, 0, 0), 64u);
  EXPECT_EQ(grid.index(0, 1, 0), 64u * 128);
  EXPECT_EQ(grid.index(0, 0, 1), 1u);
  EXPECT_EQ(grid.index(127, 127, 63), grid.cells() - 1);
}

TEST(VoxelGrid, isTheModelTurnedNotMirrored) {
  const VoxelGrid grid;
  const glm::dvec3 middle = grid.gridFromModel({0, 0, 0});
  EXPECT_EQ(middle, glm::dvec3(64, 64, 32));
  const glm::dvec3 right = grid.gridFromModel({1, 0, 0}) - middle;
  const glm::dvec3 up = grid.gridFromModel({0, 1, 0}) - middle;
  const glm::dvec3 nearer = grid.gridFromModel({0, 0, 1}) - middle;
  EXPECT_EQ(right, glm::dvec3(64, 0, 0));
  EXPECT_EQ(up, glm::dvec3(0, 0, 64));
  EXPECT_EQ(nearer, glm::dvec3(0, -64, 0));
  EXPECT_GT(glm::dot(glm::cross(right, up), nearer), 0) << "a mirror image";
  EXPECT_EQ(grid.halfHeight(), 0.5);
}

TEST(VoxelGrid, cellCentersLieInTheirCells) {
  const VoxelGrid grid{.x = 8, .y = 6, .z = 5};
  for (int x = 0; x < grid.x; ++x) {
    for (int y = 0; y < grid.y; ++y) {
      for (int z = 0; z < grid.z; ++z) {
        // The numbers are small multiples of a third: a few units of the last place of 8.
        const glm::dvec3 off = grid.gridFromModel(grid.cellCenter(x, y, z)) - glm::dvec3(x + 0.5, y + 0.5, z + 0.5);
        EXPECT_LT(glm::length(off), 1e-14);
      }
    }
  }
}

TEST(Rgb332, full_and_dark_are_themselves) {
  for (int bits = 1; bits <= kMaxShownBits; ++bits) {
    EXPECT_EQ(rgb332({0, 0, 0}, 5, bits), 0);
    EXPECT_EQ(rgb332({5, 5, 5}, 5, bits), 0xff);
    EXPECT_EQ(rgb332({5, 0, 0}, 5, bits), 0xe0);
    EXPECT_EQ(rgb332({0, 5, 0}, 5, bits), 0x1c);
    EXPECT_EQ(rgb332({0, 0, 5}, 5, bits), 0x03);
  }
}

TEST(Rgb332, rounds_to_the_nearest_level_shown_and_never_to_darkness) {
  for (int bits = 1; bits <= kMaxShownBits; ++bits) {
    for (uint64_t red = 0; red <= 84; ++red) {
      const uint64_t blue = red * 5 % 85;
      const ShownLevels shown = shownLevels(rgb332({red, 0, blue}, 84, bits), bits);
      EXPECT_EQ(shown.full.b, std::min(3, shown.full.r));
      const double wantedRed = static_cast<double>(red) / 84 * shown.full.r;
      const double wantedBlue = static_cast<double>(blue) / 84 * shown.full.b;
      if (wantedRed < 0.5 && wantedBlue < 0.5 && red + blue > 0) {
        EXPECT_EQ(shown.level.r, red >= blue ? 1 : 0);
        EXPECT_EQ(shown.level.b, blue >= red ? 1 : 0);
      } else {
        EXPECT_LE(std::abs(shown.level.r - wantedRed), 0.5);
        EXPECT_LE(std::abs(shown.level.b - wantedBlue), 0.5);
      }
      EXPECT_EQ(shown.level.g, 0);
    }
  }
}

TEST(Rgb332, bits_that_are_not_shown_repeat_those_that_are) {
  // 1/3 and 2/3 of the light in two bits are 01 and 10; the third bit is the first again.
  EXPECT_EQ(rgb332({1, 2, 1}, 3, 2), 0b010'101'01);
  EXPECT_EQ(rgb332({1, 2, 1}, 3, 3), 0b010'101'01);  // 2.33 and 4.67 of 7
}

}  // namespace
}  // namespace ocelli
