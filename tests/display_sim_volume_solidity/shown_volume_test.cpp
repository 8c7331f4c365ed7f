#include "display_sim/volume_solidity/shown_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "oc_core/base/error.h"
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

TEST(ShownVolume, IsAllOfTheVolumeByDefault) {
  const ShownVolume shown(softBall(), loadProfile("test"), {});
  EXPECT_GT(lightWhere(shown, kAnywhere), 100);
  EXPECT_EQ(shown.samples().weights(), nullptr);
}

TEST(ShownVolume, IsClipped) {
  VolumeScene scene = softBall();
  scene.clips.push_back({{0, 1, 0}, 0.1});
  const ShownVolume shown(scene, loadProfile("test"), {});
  EXPECT_GT(lightWhere(shown, kAnywhere), 10);
  EXPECT_EQ(lightWhere(shown, [](const glm::dvec3& p) { return p.y < 0.1; }), 0);
}

TEST(ShownVolume, IsCutAwayOnTheViewersSide) {
  const ShownVolume shown(softBall(), loadProfile("test"), {.eyes = {glm::vec3(10, 0, 0)}, .cutaway = 0.2});
  EXPECT_EQ(lightWhere(shown, [](const glm::dvec3& p) { return p.x > 0.2; }), 0);
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

TEST(ShownVolume, RefusesEyesInTheDisplay) {
  EXPECT_THROW(ShownVolume(softBall(), loadProfile("test"), {.eyes = {glm::vec3(0, 0, 0.5)}, .cutaway = 0}),
               InputError);
}

}  // namespace
}  // namespace ocelli
