#include "display_sim/volume_slicing/volume_slicer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <utility>
#include <vector>

#include "display_sim/dither/voxel_dither.h"
#include "display_sim/volume_slicing/volume_slice_reference.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"
#include "tests/display_sim_volume_slicing/swept_scenes.h"

namespace ocelli {
namespace {

using test::sceneOfField;
using test::sweptProfile;

VolumeScene colorfulScene() {
  const TransferFunction transfer(
      {{0, {1, 0.1, 0}, 0}, {0.4, {0, 1, 0.3}, 0.3}, {0.5, {0.2, 0, 1}, 0}, {1, {1, 1, 1}, 0.99}}, 0.1);
  return sceneOfField(
      24, 0.57, [](const glm::dvec3& p) { return 0.5 + 0.5 * std::sin(5 * p.x + p.y) * std::cos(4 * p.z - 3 * p.y); },
      transfer);
}

SweptLight lightOfScene(const VolumeScene& scene, const SweptSamples& samples) {
  return {scene.appearance.transfer, samples.range(), samples.sceneLengthOfUnit(), samples.sweep()};
}

/// Every voxel has the levels that its dither gives its light; where the light lies within rounding of a threshold,
/// either level is right. Returns how many voxels are lit.
size_t expectDithered(const SweptSamples& samples, const SweptLight& light, const Volume& volume,
                      ColorReduction dither) {
  const DisplayProfile& profile = samples.profile();
  const VoxelDither by(dither);
  const auto full = static_cast<float>(volume.fullLevel());
  size_t lit = 0;
  size_t close = 0;
  for (int slice = 0; slice < volume.slices(); ++slice) {
    const int source = slice % profile.slicesPerHalfTurn;
    const bool mirrored = slice >= profile.slicesPerHalfTurn;
    for (int row = 0; row < profile.height; ++row) {
      for (int column = 0; column < profile.width; ++column) {
        const int from = mirrored ? profile.width - 1 - column : column;
        const glm::vec3 color = light.lightOf(samples.codeAt(source, from, row), column) *
                                (static_cast<float>(samples.weightAt(source, from, row)) / 255);
        const Rgb8 levels = volume.levels(slice, column, row);
        lit += levels != Rgb8(0) ? 1 : 0;
        if (by.levels(color, volume.fullLevel(), slice, column, row) == levels) {
          continue;
        }
        ++close;
        for (int channel = 0; channel < 3; ++channel) {
          const float scaled = color[channel] * full;
          // Lights and thresholds are in 2^-20, opacities in 2^-12 (weights round them again).
          const float tolerance = (samples.weights().areFull() ? 0x1p-18f : 0x1p-11f) * full;
          const float threshold = dither == ColorReduction::kOccupancy ? 0 : by.threshold(slice, column, row);
          const float distance = std::abs(scaled - std::floor(scaled) - threshold);
          const Rgb8 wanted = by.levels(color, volume.fullLevel(), slice, column, row);
          const int allowed = dither == ColorReduction::kOccupancy ? static_cast<int>(volume.fullLevel()) : 1;
          EXPECT_LE(std::abs(static_cast<int>(levels[channel]) - static_cast<int>(wanted[channel])), allowed);
          if (wanted[channel] != levels[channel]) {
            EXPECT_LT(std::min(distance, 1 - distance), tolerance) << slice << " " << column << " " << row;
          }
        }
      }
    }
  }
  EXPECT_LT(close, lit / 50 + 2);
  return lit;
}

TEST(VolumeSlicer, GivesEachVoxelTheLevelOfItsLight) {
  const VolumeScene scene = colorfulScene();
  for (const int bits : {1, 3}) {
    const DisplayProfile profile = sweptProfile(24, 64, 48, bits);
    const SweptSamples samples(scene, profile);
    const SweptLight light = lightOfScene(scene, samples);
    for (const ColorReduction dither :
         {ColorReduction::kDither, ColorReduction::kBlueNoise, ColorReduction::kNearest, ColorReduction::kOccupancy}) {
      VolumeSlicer slicer(profile, {.colors = dither});
      EXPECT_GT(expectDithered(samples, light, slicer.slice(samples, light), dither), 300u);
    }
  }
}

TEST(VolumeSlicer, ReachesTheEndsOfScreensOfAnySize) {
  const VolumeScene scene = sceneOfField(
      20, 1, [](const glm::dvec3& p) { return p.x + p.z; },
      TransferFunction({{-2, {1, 0, 0}, 0.4}, {2, {0, 1, 1}, 1}}, 0.1));
  for (const SecondHalfTurn second : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    for (const auto& [width, height] : {std::pair{61, 35}, std::pair{64, 33}, std::pair{17, 8}}) {
      const DisplayProfile profile = sweptProfile(10, width, height, 1, second);
      const SweptSamples samples(scene, profile);
      const SweptLight light = lightOfScene(scene, samples);
      VolumeSlicer slicer(profile);
      EXPECT_GT(expectDithered(samples, light, slicer.slice(samples, light), ColorReduction::kDither), 100u);
    }
  }
}

TEST(VolumeSlicer, WeighsTheLight) {
  VolumeScene scene = colorfulScene();
  scene.appearance.shading = {.isOn = true, .ambient = 0.1, .diffuse = 0.9};
  const DisplayProfile profile = sweptProfile(24, 64, 48);
  SweptSamples samples(scene, profile);
  const SweptLight light = lightOfScene(scene, samples);
  VolumeSlicer slicer(profile);
  EXPECT_GT(expectDithered(samples, light, slicer.slice(samples, light), ColorReduction::kDither), 300u);
  samples.setPart([](const glm::dvec3& p, double) { return p.y > 0 ? 1.0 : 0.0; });
  const Volume& upper = slicer.slice(samples, light);
  EXPECT_GT(expectDithered(samples, light, upper, ColorReduction::kDither), 100u);
  for (int slice = 0; slice < upper.slices(); ++slice) {
    forEachLitVoxel(upper, slice, [&](int, int row) { ASSERT_LT(row, profile.height / 2); });
  }
}

TEST(VolumeSlicer, LeavesNothingOfTheLastVolume) {
  const VolumeScene scene = colorfulScene();
  const DisplayProfile profile = sweptProfile(24, 64, 48);
  const SweptSamples samples(scene, profile);
  VolumeSlicer slicer(profile);
  slicer.slice(samples, SweptLight(TransferFunction({{0, {1, 1, 1}, 1}}, 0.01), samples.range(), 1, samples.sweep()));
  const Volume again = slicer.slice(samples, lightOfScene(scene, samples));
  VolumeSlicer other(profile);
  EXPECT_EQ(again, other.slice(samples, lightOfScene(scene, samples)));
  EXPECT_EQ(*other.takeShared(), again);
}

TEST(VolumeSlicer, IsTheSameWithAnyNumberOfThreads) {
  const VolumeScene scene = colorfulScene();
  const DisplayProfile profile = sweptProfile(24, 64, 48);
  const SweptSamples samples(scene, profile);
  VolumeSlicer slicer(profile);
  const Volume many = slicer.slice(samples, lightOfScene(scene, samples));
  setThreadCount(1);
  const Volume one = slicer.slice(samples, lightOfScene(scene, samples));
  setThreadCount(0);
  EXPECT_EQ(one, many);
}

TEST(VolumeSlicer, TurnsTheSceneByStepsOfTheSweep) {
  const VolumeScene scene = colorfulScene();
  for (const SecondHalfTurn second : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    const DisplayProfile profile = sweptProfile(20, 32, 32, 1, second);
    const SweptSamples samples(scene, profile);
    const SweptLight light = lightOfScene(scene, samples);
    for (const int steps : {1, 7, 20, 33, -5}) {
      VolumeScene turned = scene;
      // Counter-clockwise seen from above.
      turned.worldFromIndex = glm::rotate(glm::dmat4(1), steps * kPi / 20, glm::dvec3(0, 1, 0)) * turned.worldFromIndex;
      const SweptSamples turnedSamples(turned, profile);
      const VoxelColors wanted = sweptColors(turnedSamples, lightOfScene(turned, turnedSamples));
      const VoxelColors got = sweptColors(samples, light, steps);
      for (size_t slice = 0; slice < wanted.size(); ++slice) {
        // Single precision may move a code by one step.
        ASSERT_NEAR(static_cast<double>(got[slice].size()), static_cast<double>(wanted[slice].size()),
                    0.02 * static_cast<double>(wanted[slice].size()) + 2);
        double difference = 0;
        double sum = 0;
        std::map<uint32_t, glm::vec3> byPosition;
        for (const ColoredVoxel& voxel : wanted[slice]) {
          byPosition[voxel.position] = voxel.color;
          sum += voxel.color.x + voxel.color.y + voxel.color.z;
        }
        for (const ColoredVoxel& voxel : got[slice]) {
          const glm::vec3 d = glm::abs(voxel.color - byPosition[voxel.position]);
          difference += d.x + d.y + d.z;
        }
        ASSERT_LT(difference, 0.01 * sum) << steps << " " << slice;
      }
    }
  }
}

TEST(VolumeSlicer, TurnsByTheNearestStep) {
  const SweepGeometry sweep(sweptProfile(20, 32, 32));
  EXPECT_EQ(stepsOfAngle(sweep, 0.4 * kPi / 20), 0);
  EXPECT_EQ(stepsOfAngle(sweep, 2.6 * kPi / 20), 3);
  EXPECT_EQ(stepsOfAngle(sweep, -2 * kPi - 2.6 * kPi / 20), -3);
}

TEST(VolumeSlicer, MediumIsAsBrightNearTheAxisAsFarFromIt) {
  // Light by the volume that it comes from, in rings around the axis, after the dither.
  const DisplayProfile profile = sweptProfile(60, 128, 64);
  const VolumeScene scene = sceneOfField(
      8, 1, [](const glm::dvec3&) { return 1.0; }, TransferFunction({{0, {1, 1, 1}, 0.02}}, 0.01));
  const SweptSamples samples(scene, profile);
  VolumeSlicer slicer(profile);
  const Volume& volume = slicer.slice(samples, lightOfScene(scene, samples));
  std::vector<double> lit(4);
  for (int slice = 0; slice < volume.slices(); ++slice) {
    forEachLitVoxel(volume, slice, [&](int column, int) {
      lit[static_cast<size_t>(std::min(std::abs(column - 63.5) / 8, 3.0))] += 1;
    });
  }
  // Rings of 8 columns, from r to r + 1/8: areas as 1, 3, 5. The outer half is not looked at.
  const double extinction = 2.02027;  // -ln(1 - 0.02) / 0.01
  for (size_t ring = 0; ring < 3; ++ring) {
    const double area = kPi / 64 * (2.0 * static_cast<double>(ring) + 1);
    const double cell = 2.0 / 128 * 2.0 / 64;  // width and height
    const double wanted = extinction * area * 2 / cell;
    // Cells are so thick that 1 - exp(-x) is up to 2 % below x, and dithers are not exact: 3 %.
    EXPECT_NEAR(lit[ring] / wanted, 1, 0.03) << ring;
  }
}

TEST(VolumeSlicer, SurfaceHasNoHoles) {
  // A ball's surface: every line along a slice's rows through its middle meets it twice, with about a voxel's light.
  const DisplayProfile profile = sweptProfile(24, 64, 64);
  const VolumeScene scene = sceneOfField(
      40, 0.7, [](const glm::dvec3& p) { return glm::length(p); }, TransferFunction({{0, {}, 0}}, 1));
  const SweptSamples samples(scene, profile);
  const SweptLight light = SweptLight::ofSurface(0.45, {1, 1, 1}, samples.range(), samples.sweep());
  for (int slice = 0; slice < 24; ++slice) {
    for (int row = 22; row < 42; ++row) {
      for (const int side : {0, 32}) {
        double sum = 0;
        for (int column = side; column < side + 32; ++column) {
          const float voxel = light.lightOf(samples.codeAt(slice, column, row), column).x;
          sum += voxel;
          if (voxel > 0) {
            const double distance = glm::length(samples.sweep().voxelCenter(slice, column, row));
            EXPECT_NEAR(distance, 0.45, 2 * sweptThickness(samples.sweep(), column));
          }
        }
        // Oblique to the row a surface lies in more than one of its voxels.
        EXPECT_GT(sum, 0.8);
        EXPECT_LT(sum, 3.5);
      }
    }
  }
}

TEST(VolumeSlicer, DiffusesErrors) {
  const VolumeScene scene = colorfulScene();
  const DisplayProfile profile = sweptProfile(12, 32, 32);
  const SweptSamples samples(scene, profile);
  const SweptLight light = lightOfScene(scene, samples);
  VolumeSlicer slicer(profile, {.colors = ColorReduction::kDiffusion});
  const Volume& volume = slicer.slice(samples, light);
  EXPECT_EQ(volume, ditheredVolume(sweptColors(samples, light), profile, {.colors = ColorReduction::kDiffusion}));
  EXPECT_GT(volume.litVoxels(), 100u);
}

TEST(VolumeSlicer, TellsWhichOptionsItHasNot) {
  EXPECT_EQ(unfitForVolumes({}), nullptr);
  EXPECT_STREQ(unfitForVolumes({.angularAntialiasing = true}), "--antialias");
  EXPECT_STREQ(unfitForVolumes({.evenLightRadius = 0.5}), "--even-light");
}

TEST(VolumeSliceReference, IsWhatTheSlicerComesNearTo) {
  const VolumeScene scene = colorfulScene();
  const DisplayProfile profile = sweptProfile(12, 32, 32);
  const SweptSamples samples(scene, profile);
  VolumeSlicer slicer(profile);
  const Volume& fast = slicer.slice(samples, lightOfScene(scene, samples));
  const Volume slow = VolumeSliceReference(scene, profile, 8).slice({});
  size_t differ = 0;
  size_t differInside = 0;  // of cells that no face of the volume cuts
  for (int slice = 0; slice < 12; ++slice) {
    for (int row = 0; row < 32; ++row) {
      for (int column = 0; column < 32; ++column) {
        const size_t isOther = fast.levels(slice, column, row) != slow.levels(slice, column, row) ? 1 : 0;
        differ += isOther;
        differInside += samples.weightAt(slice, column, row) == 255 ? isOther : 0;
      }
    }
  }
  // A dither turns a difference of light into that share of other voxels.
  const auto lit = static_cast<double>(slow.litVoxels());
  EXPECT_LT(static_cast<double>(differInside), 0.04 * lit);
  // A cell that a face cuts has the light of its middle. At the faces, 9 columns from the axis, it is half a column in
  // 9 thicker or thinner where it is shown: 6 % of the light of these cells, which are a fifth of all or more.
  EXPECT_LT(static_cast<double>(differ), 0.04 * lit + 0.06 * lit / 5);
  RecordProperty("differ", std::to_string(differ) + " of which inside " + std::to_string(differInside));
  EXPECT_GT(slow.litVoxels(), 300u);
}

}  // namespace
}  // namespace ocelli
