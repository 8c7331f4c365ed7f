#include "display_sim/dither/diffusion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "display_sim/dither/dither.h"
#include "display_sim/slicing/exact_slicer.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using test::smallProfile;

DisplayProfile withBits(DisplayProfile profile, int bits) {
  profile.colorBitsPerChannel = bits;
  return profile;
}

/// In full voxels.
glm::dvec3 lightOf(const Volume& volume) {
  glm::dvec3 sum(0);
  for (int slice = 0; slice < volume.slices(); ++slice) {
    forEachLevel(volume, slice,
                 [&](int, int, const Rgb8& levels) { sum += glm::dvec3(levels) / double(volume.fullLevel()); });
  }
  return sum;
}

Mesh coloredSphere() {
  Mesh mesh = test::sphere(0.8, 24);
  for (const glm::vec3& p : mesh.positions) {
    mesh.colors.push_back(0.5f + 0.55f * p);
  }
  return mesh;
}

TEST(Diffusion, losesNoLightSilently) {
  for (const int bits : {1, 2, 5}) {
    for (const SecondHalfTurn half : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
      const DisplayProfile profile = withBits(smallProfile(40, 65, 64, half), bits);
      const Diffused diffused = diffuse(colorsExactly(coloredSphere(), profile), profile);
      const glm::dvec3 shown = lightOf(diffused.volume);
      for (int channel = 0; channel < 3; ++channel) {
        // Single precision, in the order of the voxels: 2^-24 of a level for each of the 14 additions a voxel.
        EXPECT_NEAR(diffused.light[channel], shown[channel] + diffused.leftOver[channel],
                    1e-6 * diffused.light[channel]);
        // Only what ends at the last slice's voxels is left over.
        EXPECT_LT(std::abs(diffused.leftOver[channel]), 0.005 * diffused.light[channel]);
      }
    }
  }
}

TEST(Diffusion, keepsWhiteFullyLitAndBlackDarkBesideGrey) {
  for (const int bits : {1, 3, 8}) {
    const DisplayProfile profile = withBits(smallProfile(12, 32, 32), bits);
    const auto full = static_cast<uint8_t>((1 << bits) - 1);
    VoxelColors colors(12);
    for (uint32_t slice = 0; slice < 12; ++slice) {
      for (uint32_t place = 0; place < 32 * 32; ++place) {
        // A full, a dark and a grey channel, in turns.
        const uint32_t turn = (slice + place / 5) % 3;
        glm::vec3 color(0.4f);
        color[static_cast<int>(turn)] = 1;
        color[static_cast<int>(turn + 1) % 3] = 0;
        colors[slice].push_back({place, color});
      }
    }
    const Volume volume = diffuse(colors, profile).volume;
    for (uint32_t slice = 0; slice < 12; ++slice) {
      for (const ColoredVoxel& voxel : colors[slice]) {
        const Rgb8 levels = volume.levels(static_cast<int>(slice), static_cast<int>(voxel.position % 32),
                                          static_cast<int>(voxel.position / 32));
        for (int channel = 0; channel < 3; ++channel) {
          if (voxel.color[channel] != 0.4f) {
            ASSERT_EQ(levels[channel], voxel.color[channel] > 0 ? full : 0);
          }
        }
      }
    }
  }
}

TEST(Diffusion, lightsNothingBesideTheSurface) {
  const DisplayProfile profile = smallProfile(30, 48, 48);
  const Mesh mesh = coloredSphere();
  const Volume occupied = sliceExactly(mesh, profile, {ColorReduction::kOccupancy});
  const Volume diffused = sliceExactly(mesh, profile, {ColorReduction::kDiffusion});
  EXPECT_GT(diffused.litVoxels(), 0u);
  for (int slice = 0; slice < diffused.slices(); ++slice) {
    forEachLitVoxel(diffused, slice,
                    [&](int column, int row) { ASSERT_NE(occupied.colorBits(slice, column, row), 0u); });
  }
}

// Half-lit voxels whose thresholds are below a half: the first is lit, and what that is too much darkens its neighbour,
// be it in the same slice or in the next, and nobody else.
TEST(Diffusion, passesErrorsToNeighboursAlone) {
  const DisplayProfile profile = smallProfile(20, 32, 32);
  const auto lights = [](int slice, int column, int row) { return ditherThreshold(slice, column, row) < 0.5f; };
  struct Step {
    int slices, columns, rows;
    bool isNear;
  };
  int tried = 0;
  for (const Step& step : {Step{0, 1, 0, true}, Step{0, 0, 1, true}, Step{1, 0, 0, true}, Step{0, 3, 3, true},
                           Step{0, 4, 0, false}, Step{0, 0, 4, false}, Step{2, 0, 0, false}, Step{1, 4, 0, false}}) {
    for (int row = 4; row < 20; row += 2) {  // whose path leads to the right
      for (int column = 4; column < 20; ++column) {
        if (!lights(3, column, row) || !lights(3 + step.slices, column + step.columns, row + step.rows)) {
          continue;
        }
        const auto place = [](int x, int y) { return static_cast<uint32_t>(32 * y + x); };
        VoxelColors colors(20);
        colors[3].push_back({place(column, row), glm::vec3(0.5f)});
        colors[static_cast<size_t>(3 + step.slices)].push_back(
            {place(column + step.columns, row + step.rows), glm::vec3(0.5f)});
        const Volume volume = diffuse(colors, profile).volume;
        ASSERT_EQ(volume.colorBits(3, column, row), 7u);
        ASSERT_EQ(volume.colorBits(3 + step.slices, column + step.columns, row + step.rows), step.isNear ? 0u : 7u);
        ++tried;
      }
    }
  }
  EXPECT_GT(tried, 50);
}

TEST(Diffusion, givesTheSameBytesAgain) {
  const DisplayProfile profile = withBits(smallProfile(30, 48, 48), 2);
  const VoxelColors colors = colorsExactly(coloredSphere(), profile);
  EXPECT_EQ(diffuse(colors, profile).volume, diffuse(colors, profile).volume);
  EXPECT_EQ(colors, colorsExactly(coloredSphere(), profile));
}

TEST(VoxelColorsTest, unitesPlacesByTheirHighestLight) {
  SliceColors voxels = {{7, {0.1f, 0.5f, 0}}, {2, {1, 0, 0}}, {7, {0.3f, 0.2f, 0}}, {7, {0, 0, 0.9f}}};
  sortAndUnite(voxels);
  EXPECT_EQ(voxels, (SliceColors{{2, {1, 0, 0}}, {7, {0.3f, 0.5f, 0.9f}}}));
}

// Colours are those that the dither sees: reduced voxel by voxel they give the same volume.
TEST(VoxelColorsTest, areThoseOfTheExactSlicer) {
  const DisplayProfile profile = withBits(smallProfile(30, 49, 48, SecondHalfTurn::kOwn), 3);
  const Mesh mesh = coloredSphere();
  Volume volume(profile);
  const VoxelColors colors = colorsExactly(mesh, profile, {.evenLightRadius = 0.5});
  for (int slice = 0; slice < volume.slices(); ++slice) {
    for (const ColoredVoxel& voxel : colors[static_cast<size_t>(slice)]) {
      const int column = static_cast<int>(voxel.position) % 49;
      const int row = static_cast<int>(voxel.position) / 49;
      volume.raise(slice, column, row, ditheredLevels(voxel.color, volume.fullLevel(), slice, column, row));
    }
  }
  EXPECT_EQ(volume, sliceExactly(mesh, profile, {.evenLightRadius = 0.5}));
}

}  // namespace
}  // namespace ocelli
