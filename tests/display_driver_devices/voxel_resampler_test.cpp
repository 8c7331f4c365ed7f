#include "display_driver/devices/voxel_resampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include "display_sim/frames/sweep_geometry.h"
#include "tests/display_driver_devices/slow_resampler.h"

namespace ocelli {
namespace {

DisplayProfile profileOf(int slices, int width, int height, double halfHeight, int bits, bool ownSecondHalf = false) {
  DisplayProfile profile = loadProfile("vortex");
  profile.name = "of the test";
  profile.slicesPerHalfTurn = slices;
  profile.width = width;
  profile.height = height;
  profile.halfHeightRadii = halfHeight;
  profile.colorBitsPerChannel = bits;
  profile.secondHalfTurn = ownSecondHalf ? SecondHalfTurn::kOwn : SecondHalfTurn::kMirrored;
  return profile;
}

void fillSlice(Volume& volume, int slice, double density, std::mt19937& engine) {
  std::ranges::fill(volume.slice(slice), uint8_t{0});
  const auto full = static_cast<unsigned>(volume.fullLevel());
  for (int row = 0; row < volume.height(); ++row) {
    for (int column = 0; column < volume.width(); ++column) {
      if (std::uniform_real_distribution<>(0, 1)(engine) < density) {
        volume.raise(slice, column, row, Rgb8(engine() & full, engine() & full, engine() & full));
      }
    }
  }
}

Volume randomVolume(const DisplayProfile& profile, double density, std::mt19937& engine) {
  Volume volume(profile);
  for (int slice = 0; slice < volume.slices(); ++slice) {
    fillSlice(volume, slice, density, engine);
  }
  return volume;
}

std::vector<uint8_t> resampled(const Volume& volume, const VoxelGrid& grid = {}, int shownBits = 3) {
  VoxelResampler resampler(volume.profile(), grid);
  resampler.update(volume, std::nullopt, shownBits);
  return {resampler.cells().begin(), resampler.cells().end()};
}

// Slices are odd in number or multiples of 4: with others, centres of cells lie on the border of two slices, where
// rounding decides.
const std::vector<DisplayProfile>& profilesToCompare() {
  static const std::vector<DisplayProfile> profiles = {
      profileOf(12, 8, 4, 0.5, 1),       // as many voxels as cells
      profileOf(8, 6, 3, 0.5, 2, true),  // fewer, and a second half turn of its own
      profileOf(25, 19, 11, 0.5, 8),     // more, in odd numbers
      profileOf(16, 8, 8, 1, 3, true),   // higher than the grid
      profileOf(16, 10, 2, 0.2, 1),      // lower
  };
  return profiles;
}

TEST(VoxelResampler, agreesWithTheSlowWay) {
  std::mt19937 engine(1);
  const VoxelGrid grid{.x = 8, .y = 8, .z = 4};
  for (const DisplayProfile& profile : profilesToCompare()) {
    for (const double density : {0.02, 0.3, 1.0}) {
      const Volume volume = randomVolume(profile, density, engine);
      for (int bits = 1; bits <= kMaxShownBits; ++bits) {
        ASSERT_EQ(resampled(volume, grid, bits), test::slowlyResampled(volume, grid, bits))
            << profile.width << " columns, density " << density << ", " << bits << " bits";
      }
    }
  }
}

TEST(VoxelResampler, agreesWithTheSlowWayOnAnOblongGrid) {
  std::mt19937 engine(2);
  const VoxelGrid grid{.x = 6, .y = 9, .z = 5};
  const Volume volume = randomVolume(profileOf(13, 7, 6, 0.7, 3), 0.4, engine);
  EXPECT_EQ(resampled(volume, grid), test::slowlyResampled(volume, grid, 3));
}

TEST(VoxelResampler, changesInSlicesGiveWhatTheWholeVolumeGives) {
  std::mt19937 engine(3);
  const VoxelGrid grid{.x = 8, .y = 8, .z = 4};
  for (const DisplayProfile& profile : profilesToCompare()) {
    Volume volume = randomVolume(profile, 0.2, engine);
    VoxelResampler resampler(profile, grid);
    resampler.update(volume, std::nullopt, 3);
    for (int step = 0; step < 30; ++step) {
      std::vector<int> changed;
      for (int count = static_cast<int>(engine() % 4); count > 0; --count) {
        changed.push_back(static_cast<int>(engine() % static_cast<unsigned>(volume.slices())));
        fillSlice(volume, changed.back(), step % 5 == 0 ? 0 : 0.2, engine);
      }
      const int bits = 1 + static_cast<int>(engine() % 3);
      if (step % 3 == 0) {
        resampler.update(volume, std::nullopt, bits);
      } else {
        resampler.update(volume, changed, bits);
      }
      const std::vector<uint8_t> got(resampler.cells().begin(), resampler.cells().end());
      ASSERT_EQ(got, resampled(volume, grid, bits)) << "step " << step;
    }
    volume.clear();
    resampler.update(volume, std::nullopt, 3);
    EXPECT_EQ(std::ranges::count(resampler.cells(), 0), std::ssize(resampler.cells())) << "light stayed behind";
  }
}

/// Lights the voxel whose centre is nearest.
void lightAt(Volume& volume, const glm::dvec3& point, unsigned colorBits) {
  const SweepGeometry sweep(volume.profile());
  double nearest = 1e9;
  int found[3] = {};
  for (int slice = 0; slice < sweep.slicesPerHalfTurn(); ++slice) {
    for (int column = 0; column < sweep.width(); ++column) {
      for (int row = 0; row < sweep.height(); ++row) {
        const double distance = glm::distance(point, sweep.voxelCenter(slice, column, row));
        if (distance < nearest) {
          nearest = distance;
          found[0] = slice, found[1] = column, found[2] = row;
        }
      }
    }
  }
  volume.light(found[0], found[1], found[2], colorBits);
}

/// The mean place of the cells of a colour.
glm::dvec3 middleOf(const std::vector<uint8_t>& cells, const VoxelGrid& grid, uint8_t color) {
  glm::dvec3 sum(0);
  int count = 0;
  for (int x = 0; x < grid.x; ++x) {
    for (int y = 0; y < grid.y; ++y) {
      for (int z = 0; z < grid.z; ++z) {
        if (cells[grid.index(x, y, z)] == color) {
          sum += glm::dvec3(x, y, z) + 0.5;
          ++count;
        }
      }
    }
  }
  EXPECT_GT(count, 0) << "no cell has the colour " << int{color};
  return sum / static_cast<double>(std::max(count, 1));
}

// Red to the right, green up, blue towards the viewer, white behind: where a display shows x to the right, z up and y
// away from the viewer, as its simulator begins, all are where they were.
TEST(VoxelResampler, marksOnTheAxesAreWhereTheyWere) {
  Volume volume(loadProfile("vortex"));
  lightAt(volume, {0.9, 0, 0}, 1);
  lightAt(volume, {0, 0.45, 0}, 2);
  lightAt(volume, {0, 0, 0.9}, 4);
  lightAt(volume, {0, 0, -0.7}, 7);
  const VoxelGrid grid;
  const std::vector<uint8_t> cells = resampled(volume, grid);
  const auto expectNear = [&](uint8_t color, const glm::dvec3& wanted) {
    // A voxel's centre is at most half a voxel from the mark and its cell's centre half a cell from that, each way.
    const glm::dvec3 off = glm::abs(middleOf(cells, grid, color) - wanted);
    EXPECT_LE(std::max({off.x, off.y, off.z}), 1.1) << "colour " << int{color};
  };
  expectNear(0xe0, {64 + 57.6, 64, 32});
  expectNear(0x1c, {64, 64, 32 + 28.8});
  expectNear(0x03, {64, 64 - 57.6, 32});
  expectNear(0xff, {64, 64 + 44.8, 32});
}

// The letters F and L, side by side on the plane that faces the viewer.
constexpr const char* kLetters[] = {
    "####.#...", "#....#...", "###..#...", "#....#...", "#....####",
};

TEST(VoxelResampler, lettersReadAsTheyWereWritten) {
  Volume volume(loadProfile("vortex"));
  constexpr int kLeft = 70;
  constexpr int kTop = 20;
  for (int line = 0; line < 5; ++line) {
    for (int i = 0; i < 9; ++i) {
      if (kLetters[line][i] == '#') {
        volume.light(0, kLeft + i, kTop + line, 7);  // slice 0 is the plane of x and y, columns to the right
      }
    }
  }
  const VoxelGrid grid;
  const std::vector<uint8_t> cells = resampled(volume, grid);
  for (int line = 0; line < 5; ++line) {
    std::string read;
    for (int i = 0; i < 9; ++i) {
      bool lit = false;
      for (int y = 0; y < grid.y; ++y) {
        lit |= cells[grid.index(kLeft + i, y, 63 - kTop - line)] != 0;
      }
      read += lit ? '#' : '.';
    }
    EXPECT_EQ(read, kLetters[line]);
  }
  EXPECT_EQ(std::ranges::count_if(cells, [](uint8_t cell) { return cell != 0; }), 18);
}

TEST(VoxelResampler, eachVoxelIsSeenAtItsPlaceHoweverDimItIs) {
  DisplayProfile profile = profileOf(12, 10, 7, 0.5, 8);
  const VoxelGrid grid{.x = 8, .y = 8, .z = 4};
  const SweepGeometry sweep(profile);
  Volume volume(profile);
  VoxelResampler resampler(profile, grid);
  for (int slice = 0; slice < 12; ++slice) {
    for (int column = 0; column < 10; ++column) {
      for (int row = 0; row < 7; ++row) {
        volume.clear();
        volume.raise(slice, column, row, Rgb8(0, 1, 0));
        resampler.update(volume, std::nullopt, 1);
        const glm::ivec3 cell(glm::floor(grid.gridFromModel(sweep.voxelCenter(slice, column, row))));
        EXPECT_EQ(resampler.cells()[grid.index(cell.x, cell.y, cell.z)], 0x1c);
      }
    }
  }
}

TEST(VoxelResampler, aFilledVolumeFillsTheGridAsFarAsItReaches) {
  const VoxelGrid small{.x = 32, .y = 32, .z = 16};
  const std::pair<DisplayProfile, VoxelGrid> cases[] = {{loadProfile("vortex"), VoxelGrid()},
                                                        {profileOf(7, 8, 4, 0.5, 1), small},
                                                        {profileOf(36, 64, 64, 1, 1), small},
                                                        {profileOf(40, 48, 7, 0.25, 3), small}};
  for (const auto& [profile, grid] : cases) {
    Volume volume(profile);
    for (int slice = 0; slice < volume.slices(); ++slice) {
      std::ranges::fill(volume.slice(slice), uint8_t{0xff});  // widths are multiples of 8: no bits of padding
    }
    const double scale = std::min(1.0, grid.halfHeight() / profile.halfHeightRadii);
    // Wedges end in straight lines, inside of the circle by this factor.
    const double reach = std::cos(SweepGeometry(profile).stepRadians() / 2);
    const std::vector<uint8_t> cells = resampled(volume, grid);
    int dark = 0;
    for (int x = 0; x < grid.x; ++x) {
      for (int y = 0; y < grid.y; ++y) {
        for (int z = 0; z < grid.z; ++z) {
          const glm::dvec3 center = grid.cellCenter(x, y, z) / scale;
          if (std::hypot(center.x, center.z) < reach && std::abs(center.y) < profile.halfHeightRadii) {
            dark += cells[grid.index(x, y, z)] != 0xff ? 1 : 0;
          }
        }
      }
    }
    EXPECT_EQ(dark, 0) << "of a grid of " << grid.x << ", " << profile.slicesPerHalfTurn << " slices";
    EXPECT_EQ(cells[grid.index(0, 0, grid.z / 2)], 0) << "a corner of the box, which the screen does not reach";
  }
}

TEST(VoxelResampler, aSecondHalfTurnOfItsOwnIsMeanLightWithTheFirst) {
  const DisplayProfile profile = profileOf(180, 128, 64, 0.5, 1, true);
  Volume volume(profile);
  // Slice 0 at column 100, slice 180 at column 27: the same place half a turn later. Red both times, green once.
  volume.light(0, 100, 10, 1 | 2);
  volume.light(180, 27, 10, 1);
  const std::vector<uint8_t> cells = resampled(volume, {}, 3);
  // Half of 7 steps rounds up.
  EXPECT_EQ(cells[VoxelGrid().index(100, 64, 53)], 0b111'100'00);
}

TEST(VoxelResampler, darkVoxelsDoNotDimACell) {
  // Near the axis several slices fall in the cell (66, 64): the surface of one slice is as bright there as at the rim.
  Volume volume(loadProfile("vortex"));
  volume.light(0, 66, 10, 7);
  volume.light(0, 120, 10, 7);
  const std::vector<uint8_t> cells = resampled(volume);
  EXPECT_EQ(cells[VoxelGrid().index(66, 64, 53)], 0xff);
  EXPECT_EQ(cells[VoxelGrid().index(120, 64, 53)], 0xff);
}

TEST(VoxelResampler, halfTheVoxelsOfASurfaceAreHalfTheLight) {
  // A plane at right angles to the axis. A cell has 12 rows and 12 columns of a voxel's size, and some slices.
  Volume volume(loadProfile("perspecta"));
  VoxelResampler resampler(volume.profile(), {});
  const int row = volume.height() / 2 - 6;
  const auto meanLevelOf = [&](int column) {
    int sum = 0;
    int count = 0;
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 128; ++x) {
        const double radius = std::hypot(x - 63.5, y - 63.5);
        if (std::abs(radius - column) < 0.5) {
          sum += shownLevels(resampler.cells()[VoxelGrid().index(x, y, 32)], 3).level.g;
          ++count;
        }
      }
    }
    return static_cast<double>(sum) / count;
  };
  for (int slice = 0; slice < volume.slices(); ++slice) {
    for (int column = 0; column < volume.width(); ++column) {
      if ((slice + column) % 2 == 0) {
        volume.light(slice, column, row, 7);
      }
    }
  }
  resampler.update(volume, std::nullopt, 3);
  // Half of 7 levels; rounding to levels, and cells that have an odd number of voxels, make less than half of one.
  EXPECT_NEAR(meanLevelOf(16), 3.5, 0.5);
  EXPECT_NEAR(meanLevelOf(25), 3.5, 0.5);
  for (int slice = 0; slice < volume.slices(); ++slice) {
    for (int column = 0; column < volume.width(); ++column) {
      volume.light(slice, column, row, 7);
    }
  }
  resampler.update(volume, std::nullopt, 3);
  EXPECT_EQ(meanLevelOf(16), 7);
  EXPECT_EQ(meanLevelOf(25), 7);
}

}  // namespace
}  // namespace ocelli
