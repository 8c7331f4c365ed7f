#include "display_sim/volume_slicing/swept_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "display_sim/volume_slicing/volume_slice_reference.h"
#include "display_sim/volume_slicing/volume_slicer.h"
#include "oc_core/base/parallel.h"
#include "tests/display_sim_volume_slicing/swept_scenes.h"

namespace ocelli {
namespace {

using test::sceneOfField;
using test::sweptProfile;

TransferFunction grey(double opacity) {
  return TransferFunction({{0, {1, 1, 1}, opacity}}, 1);
}

TEST(SweptSamples, OfALinearFieldAreItsMeanAndSpread) {
  const DisplayProfile profile = sweptProfile(24, 64, 48);
  const glm::dvec3 slope(0.3, 0.45, -0.2);
  const VolumeScene scene = sceneOfField(
      40, 0.6, [&](const glm::dvec3& p) { return 0.5 + glm::dot(slope, p); }, grey(0.5));
  const SweptSamples samples(scene, profile);
  const SweepGeometry& sweep = samples.sweep();
  const double width = samples.range().greatest - samples.range().least;
  size_t checked = 0;
  for (int slice = 0; slice < profile.slicesPerHalfTurn; ++slice) {
    const glm::dvec2& d = sweep.sectorDirection(slice);
    for (int row = 0; row < profile.height; ++row) {
      for (int column = 0; column < profile.width; ++column) {
        const glm::dvec3 center = sweep.voxelCenter(slice, column, row);
        const double farthest = std::max({std::abs(center.x), std::abs(center.y), std::abs(center.z)});
        const uint16_t code = samples.codeAt(slice, column, row);
        // Half of the longest diagonal of a cell is 0.07.
        if (farthest > 0.6 + 0.07) {
          ASSERT_EQ(code, kNothingSwept);
          continue;
        }
        if (farthest > 0.6) {
          continue;
        }
        // Next to the faces the field is constant.
        if (farthest > 0.5) {
          ASSERT_NE(code, kNothingSwept);
          continue;
        }
        const double value = (0.5 + glm::dot(slope, center) - samples.range().least) / width;
        ASSERT_NEAR(sweptMeanOf(code), value, 0.51 / (kSweptMeans - 1));
        const double byColumn = (slope.x * d.x + slope.z * d.y) * sweep.columnWidth();
        const double byRow = slope.y * sweep.rowHeight();
        // Of cells that are thinner than wide the thickness counts for nothing.
        const double thickness = sweptThickness(sweep, column);
        const double byThickness = thickness > sweep.columnWidth() ? (slope.z * d.x - slope.x * d.y) * thickness : 0;
        const double half = std::sqrt(byColumn * byColumn + byRow * byRow + byThickness * byThickness) / 2 / width;
        // A tenth of an octave, and 0.02 for the rough logarithm and for single precision.
        ASSERT_NEAR(std::log2(sweptHalfSpreadOf(code) / half), 0, 0.12) << slice << " " << column << " " << row;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 10000u);
}

/// The mean and the greatest difference of all voxels' light to many points in each cell, by channel.
struct LightDifference {
  double mean = 0;
  double greatest = 0;
  double meanLight = 0;
};

LightDifference differenceToReference(const VolumeScene& scene, const DisplayProfile& profile, int points,
                                      int columnsFromAxis) {
  const SweptSamples samples(scene, profile, {.shaded = false});
  const SweptLight light(scene.appearance.transfer, samples.range(), samples.sceneLengthOfUnit(), samples.sweep());
  const VolumeSliceReference reference(scene, profile, points);
  LightDifference difference;
  size_t count = 0;
  for (int slice = 0; slice < profile.slicesPerHalfTurn; slice += 5) {
    for (int row = 0; row < profile.height; row += 2) {
      for (int column = profile.width / 2 - columnsFromAxis; column < profile.width / 2 + columnsFromAxis; ++column) {
        const glm::vec3 wanted = reference.lightOf(slice, column, row);
        const float weight = static_cast<float>(samples.weightAt(slice, column, row)) / 255;
        const glm::vec3 got = light.lightOf(samples.codeAt(slice, column, row), column) * weight;
        for (int channel = 0; channel < 3; ++channel) {
          const double d = std::abs(got[channel] - wanted[channel]);
          difference.mean += d;
          difference.meanLight += wanted[channel];
          difference.greatest = std::max(difference.greatest, d);
          ++count;
        }
      }
    }
  }
  difference.mean /= static_cast<double>(count);
  difference.meanLight /= static_cast<double>(count);
  return difference;
}

TEST(SweptSamples, GiveTheLightThatManyPointsInEachCellGive) {
  // A soft ball with a coloured shell: a peak of the transfer function that is narrower than what cells span.
  const TransferFunction transfer({{0.2, {1, 0, 0}, 0},
                                   {0.35, {1, 0.2, 0}, 0.6},
                                   {0.5, {0, 1, 0}, 0},
                                   {0.7, {0, 0.4, 1}, 0},
                                   {0.9, {0, 0.4, 1}, 0.9}},
                                  0.1);
  const VolumeScene scene = sceneOfField(
      48, 0.7, [](const glm::dvec3& p) { return std::exp(-4 * glm::dot(p, p)) + 0.05 * std::sin(9 * p.x); }, transfer);
  const LightDifference difference = differenceToReference(scene, sweptProfile(24, 64, 64), 8, 32);
  EXPECT_GT(difference.meanLight, 0.01);
  // Values spread evenly over a cell are exact for what is linear along one of its edges; here fields are curved and
  // oblique: within 2 % of the light.
  EXPECT_LT(difference.mean, 0.02 * difference.meanLight);
  EXPECT_LT(difference.greatest, 0.05);
}

TEST(SweptSamples, DoNotAliasNearTheAxis) {
  // A zone plate around the axis, as fine at 0.6 as the volume's voxels resolve: slices overlap in the middle, and at
  // the rim a cell holds several waves. Its light is linear in the field, so that its mean is what counts.
  const auto zonePlate = [](const glm::dvec3& p) { return 0.5 + 0.5 * std::cos(90 * (p.x * p.x + p.z * p.z)); };
  const TransferFunction transfer({{0, {1, 1, 1}, 0.001}, {1, {1, 1, 1}, 0.01}}, 1);
  const VolumeScene scene = sceneOfField(80, 0.7, zonePlate, transfer);
  for (const int columns : {4, 20}) {
    const LightDifference sampled = differenceToReference(scene, sweptProfile(40, 64, 8), 12, columns);
    // Points are a voxel apart, and the finest waves have four voxels.
    EXPECT_LT(sampled.mean, 0.04 * sampled.meanLight) << columns;
  }
  // One point in the middle of each cell is wrong by three times as much.
  const DisplayProfile profile = sweptProfile(40, 64, 8);
  const LightDifference sampled = differenceToReference(scene, profile, 12, 20);
  const VolumeSliceReference centers(scene, profile, 1);
  const VolumeSliceReference many(scene, profile, 12);
  double byCenters = 0;
  size_t count = 0;
  for (int slice = 0; slice < profile.slicesPerHalfTurn; slice += 5) {
    for (int column = 12; column < 52; ++column, ++count) {
      byCenters += std::abs(centers.lightOf(slice, column, 4).x - many.lightOf(slice, column, 4).x);
    }
  }
  EXPECT_GT(byCenters / static_cast<double>(count), 2 * sampled.mean);
}

TEST(SweptSamples, MakeVolumesCoarserThatAreFinerThanTheDisplay) {
  // Stripes of one voxel, which no column can show: what is left is their mean.
  const VolumeScene scene = sceneOfField(
      96, 0.6, [](const glm::dvec3& p) { return std::lround((p.x + 0.6) / 0.0125 - 0.5) % 2 == 0 ? 0.0 : 1.0; },
      grey(0.5));
  const SweptSamples samples(scene, sweptProfile(12, 16, 16));
  for (int slice = 0; slice < 12; ++slice) {
    for (int column = 5; column < 11; ++column) {
      // Of the five voxels that are averaged two or three are of a kind.
      EXPECT_NEAR(sweptMeanOf(samples.codeAt(slice, column, 8)), 0.5, 0.5 / 5);
    }
  }
}

TEST(SweptSamples, OfCoarserVolumesEndWhereTheVolumeEnds) {
  // 50 voxels in sixes leave two over.
  const VolumeScene scene = sceneOfField(
      50, 0.5, [](const glm::dvec3&) { return 1.0; }, grey(0.5));
  const SweptSamples samples(scene, sweptProfile(12, 16, 16));
  // Columns are 0.125 wide: the first one outside has its centre at 0.5625.
  EXPECT_NE(samples.codeAt(0, 11, 8), kNothingSwept);
  EXPECT_EQ(samples.codeAt(0, 12, 8), kNothingSwept);
  EXPECT_NE(samples.codeAt(0, 4, 8), kNothingSwept);
  EXPECT_EQ(samples.codeAt(0, 3, 8), kNothingSwept);
}

/// A volume of one voxel with these edges, centred there: a slab.
VolumeScene slabAt(const glm::dvec3& center, const glm::dvec3& edges) {
  VolumeGrid grid{.size = glm::ivec3(1)};
  grid.worldFromIndex = glm::dmat4(glm::dvec4(edges.x, 0, 0, 0), glm::dvec4(0, edges.y, 0, 0),
                                   glm::dvec4(0, 0, edges.z, 0), glm::dvec4(center, 1));
  // Thin enough that light is in proportion to the matter in a cell.
  return test::sceneOfVoxels(grid, {1}, TransferFunction({{0, {1, 1, 1}, 0.01}}, 1));
}

/// Of all voxels of the sweep.
double lightOfAll(const VolumeScene& scene, const DisplayProfile& profile) {
  const SweptSamples samples(scene, profile);
  const SweptLight light(scene.appearance.transfer, samples.range(), samples.sceneLengthOfUnit(), samples.sweep());
  double sum = 0;
  for (const SliceColors& slice : sweptColors(samples, light)) {
    for (const ColoredVoxel& voxel : slice) {
      sum += voxel.color.x;
    }
  }
  return sum;
}

struct LightSpan {
  double least = 1e30;
  double greatest = 0;

  void add(double light) {
    least = std::min(least, light);
    greatest = std::max(greatest, light);
  }
  double spread() const { return (greatest - least) / greatest; }
};

// By their centres such slabs count fully at some places, and at others not at all.
TEST(SweptSamples, OfSlabsThinnerThanAVoxelHaveTheSameLightWhereverTheyStand) {
  const DisplayProfile profile = sweptProfile(24, 64, 64);
  const double voxel = 2.0 / 64;
  LightSpan level;
  LightSpan upright;
  LightSpan twice;
  for (int i = 0; i < 10; ++i) {
    const double offset = 0.1 * i * voxel;
    level.add(lightOfAll(slabAt({0, offset, 0}, {0.9, 0.4 * voxel, 0.9}), profile));
    twice.add(lightOfAll(slabAt({0, offset, 0}, {0.9, 0.8 * voxel, 0.9}), profile));
    upright.add(lightOfAll(slabAt({0.3 + offset, 0, 0}, {0.4 * voxel, 0.9, 0.9}), profile));
  }
  RecordProperty("level", std::to_string(level.spread()));
  RecordProperty("upright", std::to_string(upright.spread()));
  // Weights are in 255ths: 0.4 of a voxel is 102 of them, rounded where it lies in two rows.
  EXPECT_LT(level.spread(), 0.01);
  EXPECT_NEAR(twice.greatest / level.greatest, 2, 0.02);
  // Cells are thinner on the side of the axis, and their light is that of their middle: half of a column, at the radius
  // 0.3, is 5 % of it.
  EXPECT_LT(upright.spread(), 0.05);
}

// So is that of a block that turns: its slanted faces have no teeth.
TEST(SweptSamples, OfABlockHaveTheSameLightHoweverItIsTurned) {
  const DisplayProfile profile = sweptProfile(24, 64, 64);
  LightSpan span;
  for (int i = 0; i < 10; ++i) {
    VolumeScene scene = slabAt({0.3, 0.01, 0.1}, {0.4, 0.3, 0.2});
    scene.worldFromIndex = glm::rotate(glm::dmat4(1), 0.157 * i, glm::dvec3(0, 1, 0)) * scene.worldFromIndex;
    span.add(lightOfAll(scene, profile));
  }
  RecordProperty("spread", std::to_string(span.spread()));
  // Shares of cells that an edge cuts are products of those of its faces, and weights are in 255ths.
  EXPECT_LT(span.spread(), 0.02);
}

TEST(SweptSamples, AtFacesGiveTheLightThatManyPointsInEachCellGive) {
  // Boxes whose faces lie in cells, also at a slant and thinner than these.
  for (const double angle : {0.0, 0.3}) {
    for (const glm::dvec3& edges : {glm::dvec3(0.61, 0.44, 0.53), glm::dvec3(0.7, 0.013, 0.4)}) {
      VolumeScene scene = slabAt({0.21, 0.04, 0.13}, edges);
      scene.worldFromIndex = glm::rotate(glm::dmat4(1), angle, glm::dvec3(0.2, 1, 0.1)) * scene.worldFromIndex;
      const LightDifference difference = differenceToReference(scene, sweptProfile(24, 64, 64), 12, 32);
      EXPECT_GT(difference.meanLight, 1e-7);
      RecordProperty("angle " + std::to_string(angle) + ", " + std::to_string(edges.y),
                     std::to_string(difference.mean / difference.meanLight));
      // The reference's 12 layers of points tell shares to a 24th, of those cells that faces cut; weights are in
      // 255ths.
      EXPECT_LT(difference.mean, 0.02 * difference.meanLight) << angle << ", " << edges.y;
    }
  }
}

TEST(SweptSamples, KeepWeightsOnlyWhereLightIsNotFull) {
  const VolumeScene scene = slabAt({0, 0, 0}, {1.2, 1.2, 1.2});
  const SweptSamples samples(scene, sweptProfile(24, 128, 128));
  EXPECT_FALSE(samples.weights().areFull());
  size_t weighed = 0;
  for (size_t brick = 0; brick < samples.bricks(); ++brick) {
    weighed += samples.weights().of(brick) != nullptr ? 1 : 0;
  }
  EXPECT_GT(weighed, 0u);
  // Bricks along the faces: of 10 x 10 and more a slice, the outermost.
  EXPECT_LT(weighed, samples.bricks() * 2 / 3);
}

TEST(SweptSamples, WeighByTheGradient) {
  const auto ball = [](const glm::dvec3& p) { return std::clamp(4 * (0.4 - glm::length(p)), 0.0, 1.0); };
  VolumeScene scene = sceneOfField(48, 0.6, ball, grey(0.5));
  // The slope is 4 by the display's radius, a voxel 0.025, the range 1: a tenth over a voxel.
  const SweptSamples samples(scene, sweptProfile(24, 64, 64), {.fullLightGradient = 0.2});
  EXPECT_NEAR(samples.weightAt(0, 32 + 9, 32), 127, 3);  // at 0.3, on the slope
  EXPECT_EQ(samples.weightAt(0, 32 + 2, 32), 0);         // in the flat middle
  EXPECT_EQ(samples.weightAt(0, 32 + 16, 32), 0);        // outside
  EXPECT_EQ(SweptSamples(scene, sweptProfile(24, 64, 64)).weightAt(0, 32 + 2, 32), 255);
}

TEST(SweptSamples, AreShadedAsTheAppearanceSays) {
  VolumeScene scene = sceneOfField(
      24, 0.6, [](const glm::dvec3& p) { return p.z; }, grey(0.5));
  scene.appearance.shading = {.isOn = true, .ambient = 0.2, .diffuse = 0.6};
  const SweptSamples samples(scene, sweptProfile(24, 32, 32));
  // The light of meshes comes from (0.45, 0.75, 0.85).
  const double cosine = 0.85 / std::sqrt(0.45 * 0.45 + 0.75 * 0.75 + 0.85 * 0.85);
  EXPECT_NEAR(samples.weightAt(3, 20, 16), 255 * (0.2 + 0.6 * cosine), 1);
  EXPECT_EQ(SweptSamples(scene, sweptProfile(24, 32, 32), {.shaded = false}).weightAt(3, 20, 16), 255);
}

TEST(SweptSamples, PartsAreTakenFromTheSampledWeights) {
  const VolumeScene scene = sceneOfField(
      24, 0.6, [](const glm::dvec3& p) { return p.z; }, grey(0.5));
  SweptSamples samples(scene, sweptProfile(24, 32, 32));
  samples.setPart([](const glm::dvec3& p, double) { return p.x > 0 ? 1.0 : 0.25; });
  samples.setPart([](const glm::dvec3& p, double) { return p.x > 0 ? 1.0 : 0.5; });
  EXPECT_EQ(samples.weightAt(0, 20, 16), 255);
  EXPECT_EQ(samples.weightAt(0, 12, 16), 128);
  samples.setPart({});
  EXPECT_EQ(samples.weightAt(0, 12, 16), 255);
}

TEST(SweptSamples, AreTheSameWithAnyNumberOfThreads) {
  const VolumeScene scene = sceneOfField(
      24, 0.6, [](const glm::dvec3& p) { return std::sin(7 * p.x) * p.y; }, grey(0.5));
  const DisplayProfile profile = sweptProfile(24, 32, 32);
  const SweptSamples many(scene, profile);
  setThreadCount(1);
  const SweptSamples one(scene, profile);
  setThreadCount(0);
  ASSERT_EQ(one.bricks(), many.bricks());
  EXPECT_TRUE(std::equal(one.codes(), one.codes() + one.bricks() * kSweptBrickVoxels, many.codes()));
}

TEST(SweptSamples, OfAVolumeBesideTheDisplayAreNone) {
  VolumeScene scene = sceneOfField(
      8, 0.1, [](const glm::dvec3& p) { return p.x; }, grey(0.5));
  scene.worldFromIndex = glm::translate(glm::dmat4(1), glm::dvec3(0, 3, 0)) * scene.worldFromIndex;
  EXPECT_EQ(SweptSamples(scene, sweptProfile(24, 32, 32)).bricks(), 0u);
}

}  // namespace
}  // namespace ocelli
