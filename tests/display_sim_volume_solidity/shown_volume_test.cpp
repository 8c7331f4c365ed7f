#include "display_sim/volume_solidity/shown_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "display_sim/volume_solidity/masked_volume.h"
#include "display_sim/volume_solidity/volume_truth.h"
#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "tests/display_sim_volume_slicing/swept_scenes.h"

namespace ocelli {
namespace {

/// A ball that is denser towards its middle.
VolumeScene softBall() {
  return test::sceneOfField(
      32, 0.6, [](const glm::dvec3& p) { return std::max(1 - glm::length(p) / 0.5, 0.0); },
      TransferFunction({{0, {1, 0, 0}, 0}, {0.3, {1, 0.5, 0}, 0.5}, {1, {1, 1, 1}, 0.9}}, 0.05));
}

/// How much light lies at voxels of which `where` holds.
double lightWhere(const ShownVolume& shown, const std::function<bool(const glm::dvec3&)>& where) {
  const SweptSamples& samples = shown.samples();
  double sum = 0;
  const VoxelColors colors = sweptColors(samples, shown.light());
  for (size_t slice = 0; slice < colors.size(); ++slice) {
    for (const ColoredVoxel& voxel : colors[slice]) {
      const auto width = static_cast<uint32_t>(samples.profile().width);
      if (where(samples.sweep().voxelCenter(static_cast<int>(slice), static_cast<int>(voxel.position % width),
                                            static_cast<int>(voxel.position / width)))) {
        sum += voxel.color.x;
      }
    }
  }
  return sum;
}

const auto kAnywhere = [](const glm::dvec3&) { return true; };

TEST(PlacedMask, LiesInTheVolumeAsTheirFilesSay) {
  VolumeScene scene = softBall();
  VolumeGrid grid = scene.volume->grid();
  // Both files say millimetres of their own, and the mask begins two voxels later.
  VolumeScene mask = scene;
  grid.worldFromIndex[3] += 2.0 * grid.worldFromIndex[0];
  mask.volume = std::make_shared<const ScalarVolume>(grid, std::vector<float>(grid.voxelCount(), 1));
  mask.worldFromIndex = grid.worldFromIndex;
  const VolumeScene placed = placedMask(mask, scene);
  for (const glm::dvec4 voxel : {glm::dvec4(0, 0, 0, 1), glm::dvec4(5, 7, 11, 1)}) {
    const glm::dvec4 there = scene.worldFromIndex * (voxel + glm::dvec4(2, 0, 0, 0));
    EXPECT_NEAR(glm::distance(placed.worldFromIndex * voxel, there), 0, 1e-9);  // a product of doubles
  }
}

TEST(ShownVolume, KnowsTheValuesOfItsSurfaces) {
  const VolumeScene ball = softBall();
  requireSurface(ball, 0.5, "ball");
  EXPECT_THROW(requireSurface(ball, 1.5, "ball"), InputError);
  EXPECT_THROW(requireSurface(ball, std::nan(""), "ball"), InputError);
}

TEST(ShownVolume, IsAllOfTheVolumeByDefault) {
  const ShownVolume shown(softBall(), loadProfile("test"), {});
  EXPECT_GT(lightWhere(shown, kAnywhere), 100);
  // Full light, but for cells at the faces of its box, where there is nothing of the ball.
  const SweptSamples& samples = shown.samples();
  for (int row = 0; row < samples.profile().height; ++row) {
    for (int column = 0; column < samples.profile().width; ++column) {
      const glm::dvec3 p = samples.sweep().voxelCenter(0, column, row);
      if (glm::length(p) < 0.45) {
        ASSERT_EQ(samples.weightAt(0, column, row), 255);
      }
    }
  }
}

TEST(ShownVolume, IsClipped) {
  VolumeScene scene = softBall();
  scene.clips.push_back({{0, 1, 0}, 0.1});
  const ShownVolume shown(scene, loadProfile("test"), {});
  EXPECT_GT(lightWhere(shown, kAnywhere), 10);
  // Cells that the plane cuts are shown in part: 64 rows, of which half of one is 1/64.
  EXPECT_EQ(lightWhere(shown, [](const glm::dvec3& p) { return p.y < 0.1 - 1.0 / 64; }), 0);
}

TEST(ShownVolume, IsClippedByTheShareOfEachCell) {
  // A plane that moves by a tenth of a row takes a tenth of the row's light, wherever it stands.
  const auto lightAbove = [](double y) {
    VolumeScene scene = test::sceneOfField(
        16, 0.6, [](const glm::dvec3&) { return 1.0; }, TransferFunction({{0, {1, 1, 1}, 0.5}}, 0.05));
    scene.clips.push_back({{0, 1, 0}, y});
    return lightWhere(ShownVolume(scene, loadProfile("test"), {}), kAnywhere);
  };
  const double row = lightAbove(0) - lightAbove(1.0 / 32);
  EXPECT_GT(row, 50);
  for (int i = 0; i < 10; ++i) {
    // Weights are in 255 steps.
    EXPECT_NEAR(lightAbove(i / 320.0) - lightAbove((i + 1) / 320.0), 0.1 * row, 0.01 * row) << i;
  }
}

TEST(ShownVolume, IsMaskedByTheShareOfEachCell) {
  // A slab of two rows, or so placed that it covers a row and two halves: the same light.
  const auto lightOfSlab = [](double least) {
    auto mask = std::make_shared<VolumeScene>(test::sceneOfField(
        2, 1, [](const glm::dvec3&) { return 1.0; }, TransferFunction({{0, {}, 0}}, 1)));
    // Its two layers are as high as two rows of the display.
    mask->worldFromIndex = glm::dmat4(1);
    mask->worldFromIndex[1][1] = 1.0 / 32;
    mask->worldFromIndex[3] = glm::dvec4(-0.5, least + 0.5 / 32, -0.5, 1);
    const VolumeScene scene = test::sceneOfField(
        16, 0.6, [](const glm::dvec3&) { return 1.0; }, TransferFunction({{0, {1, 1, 1}, 0.5}}, 0.05));
    return lightWhere(ShownVolume(scene, loadProfile("test"), {.mask = mask}), kAnywhere);
  };
  const double whole = lightOfSlab(0.001);
  EXPECT_GT(whole, 100);
  // Halves of cells are exact, but weights are in 255ths: 128 of them is 0.4 % more than a half.
  EXPECT_NEAR(lightOfSlab(0.5 / 32 + 0.001), whole, 0.01 * whole);
}

TEST(ShownVolume, IsCutAwayOnTheViewersSide) {
  const ShownVolume shown(softBall(), loadProfile("test"), {.eyes = {glm::vec3(10, 0, 0)}, .cutaway = 0.2});
  // Cells that the plane cuts are shown in part: they reach 0.033 to both sides of their centres at the most.
  EXPECT_EQ(lightWhere(shown, [](const glm::dvec3& p) { return p.x > 0.234; }), 0);
  EXPECT_GT(lightWhere(shown, [](const glm::dvec3& p) { return p.x > 0.1; }), 0);
}

TEST(ShownVolume, LeavesOutWhatViewersWouldNotSee) {
  const ShownVolume all(softBall(), loadProfile("test"), {});
  const ShownVolume shown(softBall(), loadProfile("test"), {.eyes = {glm::vec3(0, 0, 10)}, .seenOpacity = 0.5});
  const auto behind = [](const glm::dvec3& p) { return p.z < -0.1 && glm::length(p) < 0.3; };
  EXPECT_GT(lightWhere(all, behind), 20);
  EXPECT_EQ(lightWhere(shown, behind), 0);
  // What lies in front is as it was.
  const auto front = [](const glm::dvec3& p) { return p.z > 0.36; };
  EXPECT_EQ(lightWhere(shown, front), lightWhere(all, front));
  EXPECT_GT(lightWhere(shown, front), 5);
}

TEST(ShownVolume, ShowsWhatItsMaskMarks) {
  const auto mask = std::make_shared<VolumeScene>(test::sceneOfField(
      2, 1, [](const glm::dvec3& p) { return p.x > 0 ? 1.0 : 0.0; }, TransferFunction({{0, {}, 0}}, 1)));
  const ShownVolume shown(softBall(), loadProfile("test"), {.mask = mask});
  EXPECT_GT(lightWhere(shown, [](const glm::dvec3& p) { return p.x > 0; }), 50);
  EXPECT_EQ(lightWhere(shown, [](const glm::dvec3& p) { return p.x < 0; }), 0);
}

TEST(ShownVolume, ShowsASurfaceAlone) {
  const ShownVolume shown(softBall(), loadProfile("test"), {.surface = 0.4});
  // It lies at 0.3; cells are up to 0.06 thick there, and light reaches a cell to both sides.
  EXPECT_GT(lightWhere(shown, [](const glm::dvec3& p) { return std::abs(glm::length(p) - 0.3) < 0.05; }), 100);
  EXPECT_EQ(lightWhere(shown, [](const glm::dvec3& p) { return std::abs(glm::length(p) - 0.3) > 0.1; }), 0);
  // The colour that the transfer function gives it.
  const TransferFunction& transfer = shown.scene().appearance.transfer;
  EXPECT_NEAR(transfer.at(0.4).color.y, 0.5 + 0.5 / 7, 1e-9);
  EXPECT_EQ(transfer.at(0.3).extinction, 0);
}

TEST(ShownVolume, HidesBehindASurface) {
  const ShownVolume shown(softBall(), loadProfile("test"),
                          {.surface = 0.4, .eyes = {glm::vec3(0, 0, 10)}, .seenOpacity = 0.5});
  EXPECT_GT(lightWhere(shown, [](const glm::dvec3& p) { return p.z > 0.2; }), 20);
  EXPECT_EQ(lightWhere(shown, [](const glm::dvec3& p) { return p.z < -0.15; }), 0);
}

/// Opaque: red at negative z, green at positive z. The field is z.
VolumeScene redBehindGreen() {
  return test::sceneOfField(
      32, 0.5, [](const glm::dvec3& p) { return p.z; },
      TransferFunction({{-0.5, {1, 0, 0}, 0.9}, {0, {1, 0, 0}, 0.9}, {0, {0, 1, 0}, 0.9}, {0.5, {0, 1, 0}, 0.9}},
                       0.05));
}

void expectOnlyTheBackCounts(const ShownVolume& shown) {
  // Its front is seen though the green lies before it, and hides what lies deeper.
  EXPECT_GT(lightWhere(shown, [](const glm::dvec3& p) { return p.z < -0.02 && p.z > -0.15; }), 20);
  EXPECT_EQ(lightWhere(shown, [](const glm::dvec3& p) { return p.z > 0.07 || p.z < -0.35; }), 0);
  // So does the truth that solidity is measured by.
  const VolumeRenderer renderer(shown.seenScene());
  const Image<Rgb8> image = solidVolume(renderer)->opaqueImage({.width = 32, .height = 32});
  EXPECT_GT(image(16, 16).r, 240);
  // What is left between a voxel that is shown and one that is not.
  EXPECT_LT(image(16, 16).g, 100);
}

TEST(ShownVolume, IsNotHiddenByWhatItsMaskRemoves) {
  const auto mask = std::make_shared<VolumeScene>(test::sceneOfField(
      2, 1, [](const glm::dvec3& p) { return p.z < 0 ? 1.0 : 0.0; }, TransferFunction({{0, {}, 0}}, 1)));
  expectOnlyTheBackCounts(ShownVolume(redBehindGreen(), loadProfile("test"),
                                      {.mask = mask, .eyes = {glm::vec3(0, 0, 10)}, .seenOpacity = 0.5}));
}

TEST(ShownVolume, IsNotHiddenByValuesThatAreNotShown) {
  expectOnlyTheBackCounts(
      ShownVolume(redBehindGreen(), loadProfile("test"),
                  {.light = {.shown = ValueRange{-1, 0}}, .eyes = {glm::vec3(0, 0, 10)}, .seenOpacity = 0.5}));
}

TEST(ShownVolume, OfASurfaceIsTheSameBesideOneExtremeVoxel) {
  const auto litWith = [](double extreme) {
    const auto ball = [&](const glm::dvec3& p) {
      // Far from the ball, in a corner.
      return glm::length(p - glm::dvec3(0.58)) < 0.02 ? extreme : 1000 * std::max(1 - glm::length(p) / 0.5, 0.0);
    };
    const VolumeScene scene = test::sceneOfField(
        32, 0.6, ball, TransferFunction({{0, {0, 0, 0}, 0}, {std::max(extreme, 1000.0), {1, 1, 1}, 1}}, 1));
    return lightWhere(ShownVolume(scene, loadProfile("test"), {.surface = 300}), kAnywhere);
  };
  const double light = litWith(0);
  EXPECT_GT(light, 100);
  // Steps are half as wide again where the range is wider than what is common, and spreads are in tenths of an octave.
  EXPECT_NEAR(litWith(30000), light, 0.05 * light);
  EXPECT_NEAR(litWith(1e6), light, 0.05 * light);
}

TEST(ShownVolume, RefusesEyesInTheDisplay) {
  EXPECT_THROW(ShownVolume(softBall(), loadProfile("test"), {.eyes = {glm::vec3(0, 0, 0.5)}, .cutaway = 0}),
               InputError);
}

}  // namespace
}  // namespace ocelli
