#include "display_sim/volume_solidity/volume_truth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "display_sim/solidity/solidity.h"
#include "display_sim/volume_solidity/shown_volume.h"
#include "oc_core/image/color.h"
#include "tests/display_sim_volume_slicing/swept_scenes.h"

namespace ocelli {
namespace {

/// A cube so opaque that nothing of its inside is seen.
VolumeScene opaqueCube() {
  return test::sceneOfField(
      16, 0.5, [](const glm::dvec3& p) { return p.z; },
      TransferFunction({{0, {1, 0, 0}, 0.99}, {0, {0, 1, 0}, 0.99}, {0.1, {0, 1, 0}, 0.99}}, 0.02));
}

TEST(VolumeTruth, IsTheVolumesImageAsItAbsorbsLight) {
  const VolumeRenderer renderer(opaqueCube());
  const Image<Rgb8> image = solidVolume(renderer)->opaqueImage({.width = 32, .height = 32});
  EXPECT_EQ(image(16, 16), Rgb8(0, 255, 0));  // its front
  EXPECT_EQ(image(1, 1), Rgb8(0));
  const Image<Rgb8> behind = solidVolume(renderer)->opaqueImage({.eye = {0, 0, -10}, .width = 32, .height = 32});
  EXPECT_EQ(behind(16, 16), Rgb8(255, 0, 0));
}

TEST(VolumeTruth, HidesWhatLiesBehindOpacity) {
  const VolumeRenderer renderer(opaqueCube());
  const auto truth = solidVolume(renderer);
  const DisplayProfile profile = loadProfile("test");
  Volume volume(profile);
  // Slice 12 of 24 stands along z: columns to the right lie at positive z, in front.
  volume.light(12, 32 + 14, 32, 7);
  volume.light(12, 32 - 14, 32, 7);
  const Volume hidden = truth->hiddenVoxels(volume)->hiddenFrom({0, 0, 10});
  EXPECT_EQ(hidden.colorBits(12, 32 + 14, 32), 0u);
  EXPECT_EQ(hidden.colorBits(12, 32 - 14, 32), 7u);
}

TEST(VolumeTruth, NothingHiddenIsLeftForTheEyeThatAVolumeIsShownFor) {
  const VolumeScene scene = test::sceneOfField(
      24, 0.5, [](const glm::dvec3& p) { return std::sin(12 * p.x) * std::sin(12 * p.y) + p.z; },
      TransferFunction({{-0.2, {1, 0.2, 0}, 0}, {0.3, {1, 0.6, 0.2}, 0.9}, {1, {1, 1, 1}, 0.95}}, 0.02));
  const DisplayProfile profile = loadProfile("test");
  const glm::vec3 eye(0, 0, 10);
  const VolumeRenderer renderer(scene);
  const auto truth = solidVolume(renderer);
  SolidityMeter meter(*truth, {.profile = profile, .groups = {{"reference", {eye}}}});
  const auto figuresOf = [&](const ShownVolumeOptions& options) {
    const ShownVolume shown(scene, profile, options);
    VolumeSlicer slicer(profile);
    return meter.measure("", slicer.slice(shown.samples(), shown.light()), 0);
  };
  const SolidityFigures all = figuresOf({});
  const SolidityFigures seen = figuresOf({.eyes = {eye}, .seenOpacity = 0.5});
  EXPECT_GT(all.groups[0].hiddenShare(), 0.5);
  // Exactly what this eye's own image calls hidden is left out.
  EXPECT_EQ(seen.groups[0].hiddenShare(), 0);
  EXPECT_LT(seen.litVoxels, all.litVoxels);
  EXPECT_GT(seen.litVoxels, 100u);
}

}  // namespace
}  // namespace ocelli
